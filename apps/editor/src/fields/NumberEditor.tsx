import type { NumberField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { stepOf } from './stepOf';

export function NumberEditor({ field, value, onPreview, onCommit, ...rest }: FieldEditorProps<NumberField>): ReactNode {
  return (
    <NumberInput
      {...rest}
      value={value}
      min={field.min}
      max={field.max}
      step={stepOf(field)}
      unit={field.unit}
      handle={<span className="grip" />}
      onPreview={(next) => onPreview(field.integer ? Math.round(next) : next)}
      onCommit={() => onCommit()}
    />
  );
}
