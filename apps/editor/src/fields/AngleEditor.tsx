import type { AngleField } from '@farol/engine/fields';
import { MathUtils } from 'three';
import type { ReactNode } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** Radians as degrees, without the digits that the conversion adds. */
export const toDegrees = (radians: number): number => Number((radians * MathUtils.RAD2DEG).toFixed(9));

const inDegrees = (radians: number | undefined): number | undefined =>
  radians === undefined ? undefined : toDegrees(radians);

/** Keeps a converted limit from falling outside of itself. */
const inRange = (radians: number, { min = -Infinity, max = Infinity }: AngleField): number =>
  Math.min(max, Math.max(min, radians));

export function AngleEditor({ field, value, onPreview, onCommit, ...rest }: FieldEditorProps<AngleField>): ReactNode {
  return (
    <NumberInput
      {...rest}
      value={value === null ? null : toDegrees(value)}
      min={inDegrees(field.min)}
      max={inDegrees(field.max)}
      step={field.step === undefined ? 1 : toDegrees(field.step)}
      unit="°"
      handle={<span className="grip" />}
      onPreview={(next) => onPreview(inRange(next * MathUtils.DEG2RAD, field))}
      onCommit={() => onCommit()}
    />
  );
}
