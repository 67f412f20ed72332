import type { Vector3Field } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { stepOf } from './stepOf';
import { TripleEditor } from './TripleEditor';

const same = (value: number): number => value;

export function Vector3Editor({ field, onCommit, ...rest }: FieldEditorProps<Vector3Field>): ReactNode {
  return (
    <TripleEditor
      {...rest}
      min={field.min}
      max={field.max}
      step={stepOf(field)}
      toShown={same}
      fromShown={same}
      onCommit={() => onCommit()}
    />
  );
}
