import { firstLanguage, type Language } from './languages';
import { setTexts, type Texts } from './translate';

/** Key of the chosen language in localStorage, common to the viewer and the Lab of one host. */
const KEY = 'farol-language';

type FetchTexts = () => Promise<Texts>;

let requested: Language = 'en';

function chosenLanguage(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null; // storage is unavailable
  }
}

/**
 * Sets a page's language and `<html lang>`, and stores the choice if storage is available. Existing elements are not
 * changed: make them again afterwards.
 * @param fetchSpanish - fetches the page's Spanish texts
 * @returns false when another language was chosen meanwhile
 * @throws Error (as a rejection) when the texts cannot be fetched; the language then stays
 */
export async function showPageLanguage(language: Language, fetchSpanish: FetchTexts): Promise<boolean> {
  requested = language;
  const texts = language === 'en' ? {} : await fetchSpanish();
  if (requested !== language) return false;
  setTexts(texts, language);
  document.documentElement.lang = language;
  try {
    localStorage.setItem(KEY, language);
  } catch {
    // without storage the choice lasts until the page is left
  }
  return true;
}

/**
 * Sets the initial language of a page: the one chosen on this device, else the browser's, else English; English when
 * the texts cannot be fetched.
 * @param fetchSpanish - fetches the page's Spanish texts
 */
export async function startPageLanguage(fetchSpanish: FetchTexts): Promise<Language> {
  const language = firstLanguage(chosenLanguage(), navigator.languages);
  if (language === 'en') return 'en';
  try {
    setTexts(await fetchSpanish(), language);
  } catch {
    return 'en';
  }
  document.documentElement.lang = language;
  return language;
}
