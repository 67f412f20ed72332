/** Theme of the page: 'system' follows the operating system's setting. */
export type Theme = 'system' | 'light' | 'dark';

const KEY = 'farol-lab-theme';

/** The stored theme; 'system' if none is stored, or without storage. */
export function storedTheme(): Theme {
  try {
    const value = localStorage.getItem(KEY);
    return value === 'light' || value === 'dark' ? value : 'system';
  } catch {
    return 'system';
  }
}

export function applyTheme(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
}

export function storeTheme(theme: Theme): void {
  applyTheme(theme);
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // without storage the theme lasts until the page is reloaded
  }
}
