import { toDegrees, toRadians } from './angles';
import type { FieldDescription } from './FieldTarget';
import { stepOf } from './stepOf';

/** Unit, limits and step of a field's displayed and typed numbers, with conversion in both directions. */
export interface NumberDisplay {
  /** Displayed unit, such as '°'; undefined for a pure number. */
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
  /** Step of arrow keys and dragging, in the displayed unit; above 0. */
  readonly step: number;
  /** Converts from the field's unit to the displayed unit. */
  toShown(value: number): number;
  /** Converts from the displayed unit to the field's unit. */
  fromShown(shown: number): number;
}

/** Slightly more than half of the last digit that `toDegrees` keeps (rad). */
const ROUNDING = 1e-10;

const same = (value: number): number => value;

/** Display of a number or of a vector's coordinates; angles are displayed in degrees. */
export function numberDisplay(field: FieldDescription): NumberDisplay {
  const { min, max, unit, scale = 1 } = field;
  if (scale !== 1) return scaled(field, scale);
  if (field.kind !== 'angle' && field.kind !== 'euler') {
    return { unit, min, max, step: stepOf(field), toShown: same, fromShown: field.integer ? Math.round : same };
  }
  const limits = [min, max].filter((limit) => limit !== undefined);
  return {
    unit: '°',
    min: min === undefined ? undefined : toDegrees(min),
    max: max === undefined ? undefined : toDegrees(max),
    step: field.step === undefined ? 1 : toDegrees(field.step),
    toShown: toDegrees,
    // the displayed limit is rounded: entering it must give the exact limit, not a value beyond it
    fromShown(shown) {
      const radians = toRadians(shown);
      return limits.find((limit) => Math.abs(limit - radians) < ROUNDING) ?? radians;
    },
  };
}

/** Significant digits kept when a number is converted to another unit. */
const DIGITS = 7;

/** Display of a number in another unit; its step is scaled by a power of ten. */
function scaled(field: FieldDescription, scale: number): NumberDisplay {
  const { min, max, unit } = field;
  return {
    unit,
    min: min === undefined ? undefined : min * scale,
    max: max === undefined ? undefined : max * scale,
    step: stepOf(field) * 10 ** Math.round(Math.log10(scale)),
    toShown: (value) => Number((value * scale).toPrecision(DIGITS)),
    fromShown: (shown) => shown / scale,
  };
}
