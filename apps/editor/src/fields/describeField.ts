import type { Field } from '@farol/engine/fields';
import { toDegrees } from './AngleEditor';

/** Help of a field with its unit and range, in one line. */
export function describeField(field: Field): string {
  const range = rangeOf(field);
  return range ? `${field.help} ${range}` : field.help;
}

function rangeOf(field: Field): string {
  if (field.kind !== 'number' && field.kind !== 'angle' && field.kind !== 'vector3') return '';
  const isAngle = field.kind === 'angle';
  const shown = (value: number): string => `${Number((isAngle ? toDegrees(value) : value).toPrecision(4))}`;
  const unit = isAngle ? '°' : field.unit ? ` ${field.unit}` : '';
  const { min, max } = field;
  if (min !== undefined && max !== undefined) return `From ${shown(min)} to ${shown(max)}${unit}.`;
  if (min !== undefined) return `At least ${shown(min)}${unit}.`;
  if (max !== undefined) return `At most ${shown(max)}${unit}.`;
  return field.kind === 'vector3' && field.unit ? `In ${field.unit}.` : '';
}
