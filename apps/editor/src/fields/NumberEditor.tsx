import { numberDisplay, suitsSlider } from '@farol/editing';
import type { AngleField, NumberField } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** A number, or an angle in degrees; with a slider if it has a range. */
export function NumberEditor(props: FieldEditorProps<NumberField | AngleField>): ReactNode {
  const { field, value, onPreview, onCommit, ...rest } = props;
  const { toShown, fromShown, ...shown } = useMemo(() => numberDisplay(field), [field]);
  return (
    <NumberInput
      {...rest}
      {...shown}
      value={value === null ? null : toShown(value)}
      handle={<span className="grip" />}
      scrubsLabel
      slider={suitsSlider(shown)}
      onPreview={(next) => onPreview(fromShown(next))}
      onPreviewEach={(update) => onPreview((before) => fromShown(update(toShown(before))))}
      onCommit={() => onCommit()}
    />
  );
}
