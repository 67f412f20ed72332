import type { Action } from '../api/Action';
import { type Language, languages } from '../language/languages';
import { showLanguage, shownLanguage } from '../language/shownLanguage';

/** One action for each language; the choice is remembered. */
export const chooseLanguage: readonly Action[] = Object.entries(languages).map(([language, label]) => ({
  id: `help.language.${language}`,
  label,
  menu: { menu: 'help', group: 'language', submenu: 'Language' },
  async run({ preferences }) {
    await showLanguage(language as Language);
    preferences.setState({ language: language as Language });
  },
  checked: () => shownLanguage() === language,
}));
