/** Languages of the editor, by what each calls itself. */
export const languages = { en: 'English', es: 'Español' } as const;

export type Language = keyof typeof languages;

const isLanguage = (name: unknown): name is Language => typeof name === 'string' && Object.hasOwn(languages, name);

/**
 * The language to begin with.
 * @param chosen - what the user has chosen before; anything else counts as nothing
 * @param ofBrowser - tags of BCP 47, the most wanted first
 * @returns what was chosen, else the first of the browser's that there is, else English
 */
export function firstLanguage(chosen: unknown, ofBrowser: readonly string[]): Language {
  if (isLanguage(chosen)) return chosen;
  return ofBrowser.map((tag) => tag.split('-')[0].toLowerCase()).find(isLanguage) ?? 'en';
}
