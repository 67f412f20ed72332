import { t } from '../language/translate';
import type { FieldValue, Vector3Tuple } from './Field';
import type { FieldDescription } from './FieldTarget';
import { isTriple } from './sameValue';
import { formatNumber } from './formatNumber';
import { numberDisplay } from './NumberDisplay';
import { splitColour } from './screenColour';

/** Text of a field's value with unit: '5 m', '45°', '#ff8800 × 2'; null if there is no readable text, as for ids. */
export function valueText(field: FieldDescription, value: FieldValue): string | null {
  if (field.kind === 'colour') {
    const { hex, intensity } = splitColour(value as Vector3Tuple);
    return intensity > 1 ? `${hex} × ${formatNumber(intensity, 'short')}` : hex;
  }
  if (typeof value === 'number' || isTriple(value)) {
    const { unit, toShown } = numberDisplay(field);
    // 'cd or lx' is not the unit of a single value
    const suffix = unit === '°' ? unit : unit && !unit.includes(' or ') ? ` ${t(unit)}` : '';
    if (typeof value === 'number') return `${formatNumber(toShown(value), 'long')}${suffix}`;
    return `${value.map((each) => Number(toShown(each).toFixed(3)) + 0).join(', ')}${suffix}`;
  }
  if (field.kind === 'asset') return value === null ? t('none') : String(value);
  if (field.kind === 'choice') return t(String(value));
  return field.kind === 'string' ? `“${value as string}”` : null;
}
