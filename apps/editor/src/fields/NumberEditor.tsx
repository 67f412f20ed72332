import { numberDisplay } from '@farol/editing';
import type { AngleField, NumberField } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** A number, or an angle in degrees. */
export function NumberEditor(props: FieldEditorProps<NumberField | AngleField>): ReactNode {
  const { field, value, onPreview, onCommit, ...rest } = props;
  const { toShown, fromShown, ...shown } = useMemo(() => numberDisplay(field), [field]);
  return (
    <NumberInput
      {...rest}
      {...shown}
      value={value === null ? null : toShown(value)}
      handle={<span className="grip" />}
      onPreview={(next) => onPreview(fromShown(next))}
      onCommit={() => onCommit()}
    />
  );
}
