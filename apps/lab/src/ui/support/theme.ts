/** Colours of the page: those of the system, or always light or dark ones. */
export type Theme = 'system' | 'light' | 'dark';

const KEY = 'farol-lab-theme';

/** The theme that was chosen last; `system` without one, and where the browser keeps nothing. */
export function storedTheme(): Theme {
  try {
    const value = localStorage.getItem(KEY);
    return value === 'light' || value === 'dark' ? value : 'system';
  } catch {
    return 'system';
  }
}

/** Shows the page in a theme. */
export function applyTheme(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
}

/** Shows the page in a theme, also after the page is loaded again. */
export function storeTheme(theme: Theme): void {
  applyTheme(theme);
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // the browser keeps nothing: the theme lasts until the page is loaded again
  }
}
