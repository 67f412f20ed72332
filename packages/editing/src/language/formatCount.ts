import { textLanguage } from './translate';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const short = new Intl.NumberFormat('en', { notation: 'compact', maximumFractionDigits: 1 });

/**
 * A number of things, its thousands apart. The editors write decimals with a point in every language, as their fields read
 * them: a comma between thousands would be read as one of decimals outside of English, so that a narrow blank is there.
 * @param count - rounded to a whole number
 * @param isShort - as '151.7K'
 */
export function formatCount(count: number, isShort = false): string {
  const text = (isShort ? short : whole).format(count);
  return textLanguage() === 'en' ? text : text.replaceAll(',', '\u202f');
}
