/** Texts of a language by the English texts in the code. `{name}` is a placeholder for a value. */
export type Texts = Readonly<Record<string, string>>;

let texts: Texts = {};
let language = 'en';

/**
 * Sets the language of all texts returned from now on.
 * @param wanted - texts by their English texts; empty for English
 * @param name - code of the language, such as 'es'
 */
export function setTexts(wanted: Texts, name = 'en'): void {
  texts = wanted;
  language = name;
}

/** Code of the current language, such as 'es'. */
export const textLanguage = (): string => language;

/**
 * Locale of the current language, for dates and lists, with the country if the browser's languages have one.
 * @returns a tag of BCP 47, such as 'es-MX'
 */
export function textLocale(): string {
  const ofBrowser = globalThis.navigator?.languages ?? [];
  return ofBrowser.find((tag) => tag.split('-')[0].toLowerCase() === language) ?? language;
}

/**
 * Translates a text into the current language. The English text is its key: `t('Box {number}', { number: 2 })`. Call it
 * when the text is needed, not at module level, since the language may change. A note after '##' is not shown; it
 * separates meanings: 'Scale##verb' and 'Scale' differ in other languages.
 * @param english - a literal, so that a test finds texts without a translation
 * @param values - values of the placeholders; one without a value stays as `{name}`
 */
export function t(english: string, values?: Readonly<Record<string, string | number>>): string {
  const text = Object.hasOwn(texts, english) ? texts[english]! : withoutNote(english);
  if (!values) return text;
  return text.replace(/\{(\w+)\}/g, (whole, name: string) =>
    Object.hasOwn(values, name) ? String(values[name]) : whole,
  );
}

function withoutNote(english: string): string {
  const end = english.indexOf('##');
  return end < 0 ? english : english.slice(0, end);
}

/**
 * Translated text with a count, in one form for 1 and another for all other counts. `{count}` is the placeholder.
 * @param one - for a count of 1, such as '{count} light'
 * @param many - for any other, such as '{count} lights'
 */
export function tCount(
  count: number,
  one: string,
  many: string,
  values?: Readonly<Record<string, string | number>>,
): string {
  return t(count === 1 ? one : many, { count, ...values });
}
