import { setTexts, Signal, t, type Texts } from '@farol/editing';
import type { Language } from './languages';

interface LanguageTexts {
  readonly texts: Texts;
  /** Puts what the engine says into the language. */
  readonly ofEngine: (message: string) => string;
}

const asItIs = (message: string): string => message;

const loaders: Readonly<Record<Language, () => Promise<LanguageTexts>>> = {
  en: async () => ({ texts: {}, ofEngine: asItIs }),
  es: async () => {
    const { es, ofEngine } = await import('./es');
    return { texts: es, ofEngine };
  },
};

let shown: Language = 'en';
let translate = asItIs;
/** The language that was asked for last: its texts may come after those of one that was asked for later. */
let asked: Language = 'en';

/** Emits once another language is shown. One for all editors of the page, as the texts are. */
export const languageChanged = new Signal();

/** The language that is shown. */
export const shownLanguage = (): Language => shown;

/** A message in the language that is shown, where the engine said it or a part of it: the engine speaks English alone. */
export const inShownLanguage = (message: string): string => translate(message);

/**
 * Shows the page in a language, once its texts are there.
 * @throws Error (as a rejection) when they cannot be fetched; the language before stays
 */
export async function showLanguage(language: Language): Promise<void> {
  asked = language;
  let loaded: LanguageTexts;
  try {
    loaded = await loaders[language]();
  } catch (cause) {
    throw new Error(t('The texts of this language could not be loaded: is the server there?'), { cause });
  }
  if (asked !== language || shown === language) return;
  shown = language;
  setTexts(loaded.texts, language);
  translate = loaded.ofEngine;
  document.documentElement.lang = language;
  languageChanged.emit();
}
