import { numberDisplay } from '@farol/editing';
import type { AngleField, NumberField } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** Of a range with more steps a slider would be too coarse. */
const STEPS = 2048;

/** A number, or an angle in degrees; with a slider where it has a range. */
export function NumberEditor(props: FieldEditorProps<NumberField | AngleField>): ReactNode {
  const { field, value, onPreview, onCommit, ...rest } = props;
  const { toShown, fromShown, ...shown } = useMemo(() => numberDisplay(field), [field]);
  const { min, max, step } = shown;
  return (
    <NumberInput
      {...rest}
      {...shown}
      value={value === null ? null : toShown(value)}
      handle={<span className="grip" />}
      scrubsLabel
      slider={min !== undefined && max !== undefined && (max - min) / step <= STEPS}
      onPreview={(next) => onPreview(fromShown(next))}
      onPreviewEach={(update) => onPreview((before) => fromShown(update(toShown(before))))}
      onCommit={() => onCommit()}
    />
  );
}
