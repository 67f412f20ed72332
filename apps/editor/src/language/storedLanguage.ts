import { firstLanguage, type Language } from '@farol/editing';

/**
 * The language to start with, before an editor exists.
 * @param storage - prefix of the editor's keys in localStorage
 */
export function storedLanguage(storage: string): Language {
  let chosen: unknown = null;
  try {
    const kept = JSON.parse(localStorage.getItem(storage) ?? '{}') as { state?: { language?: unknown } };
    chosen = kept.state?.language;
  } catch {
    // the browser has no storage, or its content is malformed
  }
  return firstLanguage(chosen, navigator.languages);
}
