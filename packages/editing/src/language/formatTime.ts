import { textLocale } from './translate';

const formats = new Map<string, Intl.DateTimeFormat>();

/**
 * Formats a time of day, to the second, in the current language.
 * @param time - ms since 1970
 * @param withDate - includes the date
 */
export function formatTime(time: number, withDate = false): string {
  const locale = textLocale();
  const key = `${locale} ${withDate}`;
  let format = formats.get(key);
  if (!format) {
    format = new Intl.DateTimeFormat(locale, { timeStyle: 'medium', ...(withDate && { dateStyle: 'medium' }) });
    formats.set(key, format);
  }
  return format.format(time);
}
