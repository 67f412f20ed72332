import { setTexts, type Texts } from '@farol/editing';
import { es } from './es';

const texts = { en: {}, es } as const satisfies Readonly<Record<string, Texts>>;

/** Languages of the attached editor. */
export type AttachLanguage = keyof typeof texts;

/** Name of each language in that language itself. */
export const languages: Readonly<Record<AttachLanguage, string>> = { en: 'English', es: 'Español' };

/** First of the browser's languages that the editor has texts for, else English. */
export function browserLanguage(): AttachLanguage {
  const names = navigator.languages.map((tag) => tag.split('-')[0].toLowerCase());
  return names.find((name): name is AttachLanguage => Object.hasOwn(texts, name)) ?? 'en';
}

/** Sets the language of all panels made after this call, for all attached editors of the page. */
export function speak(language: AttachLanguage): void {
  setTexts(texts[language], language);
}
