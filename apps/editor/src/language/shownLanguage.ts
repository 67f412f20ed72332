import { setTexts, Signal, t, type Texts } from '@farol/editing';
import type { Language } from './languages';

const loaders: Readonly<Record<Language, () => Promise<Texts>>> = {
  en: async () => ({}),
  es: async () => (await import('./es')).es,
};

let shown: Language = 'en';
/** The language that was asked for last: its texts may come after those of one that was asked for later. */
let asked: Language = 'en';

/** Emits once another language is shown. One for all editors of the page, as the texts are. */
export const languageChanged = new Signal();

/** The language that is shown. */
export const shownLanguage = (): Language => shown;

/**
 * Shows the page in a language, once its texts are there.
 * @throws Error (as a rejection) when they cannot be fetched; the language before stays
 */
export async function showLanguage(language: Language): Promise<void> {
  asked = language;
  let texts: Texts;
  try {
    texts = await loaders[language]();
  } catch (cause) {
    throw new Error(t('The texts of this language could not be loaded: is the server there?'), { cause });
  }
  if (asked !== language || shown === language) return;
  shown = language;
  setTexts(texts, language);
  document.documentElement.lang = language;
  languageChanged.emit();
}
