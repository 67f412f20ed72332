import { textLocale } from './translate';

const formats = new Map<string, Intl.DateTimeFormat>();

/**
 * A moment in the language that is shown: its time of day, to the second.
 * @param time - ms since 1970
 * @param withDate - says the day too
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
