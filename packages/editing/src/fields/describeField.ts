import type { FieldDescription } from './FieldTarget';
import { t } from '../language/translate';
import { numberDisplay } from './NumberDisplay';

/** Help of a field with its unit and range, in one line. Angles are in degrees. */
export function describeField(field: FieldDescription): string {
  const range = rangeOf(field);
  return range ? `${t(field.help)} ${range}` : t(field.help);
}

function rangeOf(field: FieldDescription): string {
  if (field.kind !== 'number' && field.kind !== 'angle' && field.kind !== 'vector3') return '';
  const { min, max, unit: name } = numberDisplay(field);
  const shown = (value: number): string => String(Number(value.toPrecision(4)));
  const unit = name === '°' ? name : name ? ` ${t(name)}` : '';
  if (min !== undefined && max !== undefined)
    return t('From {min} to {max}{unit}.', { min: shown(min), max: shown(max), unit });
  if (min !== undefined) return t('At least {min}{unit}.', { min: shown(min), unit });
  if (max !== undefined) return t('At most {max}{unit}.', { max: shown(max), unit });
  return field.kind === 'vector3' && name ? t('In {unit}.', { unit: t(name) }) : '';
}
