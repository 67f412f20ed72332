import { setTexts, type Texts } from '@farol/editing';
import { es } from './es';

const texts = { en: {}, es } as const satisfies Readonly<Record<string, Texts>>;

export type AttachLanguage = keyof typeof texts;

/** Languages by what each calls itself. */
export const languages: Readonly<Record<AttachLanguage, string>> = { en: 'English', es: 'Español' };

/** The first of the browser's languages that there is, else English. */
export function browserLanguage(): AttachLanguage {
  const names = navigator.languages.map((tag) => tag.split('-')[0].toLowerCase());
  return names.find((name): name is AttachLanguage => Object.hasOwn(texts, name)) ?? 'en';
}

/** Shows all that is made from now on in a language: one for all attached editors of the page. */
export function speak(language: AttachLanguage): void {
  setTexts(texts[language], language);
}
