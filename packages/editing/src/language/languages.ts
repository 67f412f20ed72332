/** Languages of the apps, each with its name in that language. */
export const languages = { en: 'English', es: 'Español' } as const;

/** Codes of the languages of the apps. */
export type Language = keyof typeof languages;

const isLanguage = (name: unknown): name is Language => typeof name === 'string' && Object.hasOwn(languages, name);

/**
 * The language to start with.
 * @param chosen - stored choice of the user; anything but a language is ignored
 * @param ofBrowser - BCP 47 tags, the preferred first
 * @returns the chosen language, else the browser's first supported one, else English
 */
export function firstLanguage(chosen: unknown, ofBrowser: readonly string[]): Language {
  if (isLanguage(chosen)) return chosen;
  return ofBrowser.map((tag) => tag.split('-')[0].toLowerCase()).find(isLanguage) ?? 'en';
}
