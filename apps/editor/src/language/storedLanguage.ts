import { firstLanguage, type Language } from './languages';

/**
 * The language to begin with, before there is an editor.
 * @param storage - where the editor's preferences are kept in the browser
 */
export function storedLanguage(storage: string): Language {
  let chosen: unknown = null;
  try {
    const kept = JSON.parse(localStorage.getItem(storage) ?? '{}') as { state?: { language?: unknown } };
    chosen = kept.state?.language;
  } catch {
    // no storage, or not ours
  }
  return firstLanguage(chosen, navigator.languages);
}
