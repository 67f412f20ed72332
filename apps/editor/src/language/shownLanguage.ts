import { type Language, setTexts, Signal, t, type Texts } from '@farol/editing';

interface LanguageTexts {
  readonly texts: Texts;
  /** Translates messages of the engine. */
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
/** The language requested last; texts of languages requested earlier may still arrive, and are ignored. */
let asked: Language = 'en';

/** Emits when the language changes, which is common to all editors of the page. */
export const languageChanged = new Signal();

export const shownLanguage = (): Language => shown;

/** Translates a text that contains messages of the engine, which are English only. */
export const inShownLanguage = (message: string): string => translate(message);

/**
 * Switches the language of the page, once its texts are fetched.
 * @throws Error (as a rejection) when they cannot be fetched; the language then stays
 */
export async function showLanguage(language: Language): Promise<void> {
  asked = language;
  let loaded: LanguageTexts;
  try {
    loaded = await loaders[language]();
  } catch (cause) {
    throw new Error(t('The texts of this language could not be loaded: reload the page.'), { cause });
  }
  if (asked !== language || shown === language) return;
  shown = language;
  setTexts(loaded.texts, language);
  translate = loaded.ofEngine;
  document.documentElement.lang = language;
  languageChanged.emit();
}
