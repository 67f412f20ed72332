/** Texts of a language: its text for each English text in the code. `{name}` stands for a value that is filled in. */
export type Texts = Readonly<Record<string, string>>;

let texts: Texts = {};
let language = 'en';

/**
 * Sets the language of all texts shown from now on.
 * @param wanted - texts by their English ones; none for English
 * @param name - of the language, such as 'es'
 */
export function setTexts(wanted: Texts, name = 'en'): void {
  texts = wanted;
  language = name;
}

/** The name of the language that is shown, such as 'es'. */
export const textLanguage = (): string => language;

/**
 * The language that is shown, as dates and lists need it: as the browser has it, with its country, else by itself.
 * @returns a tag of BCP 47, such as 'es-MX'
 */
export function textLocale(): string {
  const ofBrowser = globalThis.navigator?.languages ?? [];
  return ofBrowser.find((tag) => tag.split('-')[0].toLowerCase() === language) ?? language;
}

/**
 * A text in the language that is shown. The English text is its name: `t('Box {number}', { number: 2 })`. Call it where
 * the text is shown, not where a module begins: the language may change. What follows '##' is a note, which is not
 * shown: 'Scale##verb', where other languages have another word for what one does than for what one has.
 * @param english - a literal, so that a test finds it and misses no text of another language
 * @param values - what stands for `{name}`; a name without a value stays as it is
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
 * Text for a number of things, with one form for 1 and one for all other counts. `{count}` is filled in.
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
