import { textLanguage } from './translate';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const short = new Intl.NumberFormat('en', { notation: 'compact', maximumFractionDigits: 1 });

/**
 * Formats a count with separated thousands. Editors use a decimal point in every language, as their fields parse it;
 * outside of English a comma between thousands would look like a decimal comma, so a narrow blank is used.
 * @param count - rounded to a whole number
 * @param isShort - abbreviates, as in '151.7K'
 */
export function formatCount(count: number, isShort = false): string {
  const text = (isShort ? short : whole).format(count);
  return textLanguage() === 'en' ? text : text.replaceAll(',', '\u202f');
}
