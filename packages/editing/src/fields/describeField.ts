import type { FieldDescription } from './FieldTarget';
import { numberDisplay } from './NumberDisplay';

/** Help of a field with its unit and range, in one line. Angles are in degrees. */
export function describeField(field: FieldDescription): string {
  const range = rangeOf(field);
  return range ? `${field.help} ${range}` : field.help;
}

function rangeOf(field: FieldDescription): string {
  if (field.kind !== 'number' && field.kind !== 'angle' && field.kind !== 'vector3') return '';
  const { min, max, unit: name } = numberDisplay(field);
  const shown = (value: number): string => String(Number(value.toPrecision(4)));
  const unit = name === '°' ? name : name ? ` ${name}` : '';
  if (min !== undefined && max !== undefined) return `From ${shown(min)} to ${shown(max)}${unit}.`;
  if (min !== undefined) return `At least ${shown(min)}${unit}.`;
  if (max !== undefined) return `At most ${shown(max)}${unit}.`;
  return field.kind === 'vector3' && name ? `In ${name}.` : '';
}
