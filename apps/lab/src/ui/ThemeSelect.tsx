import { t } from '@farol/editing';
import { useState } from 'preact/hooks';
import { Select } from './Select';
import { storedTheme, storeTheme, type Theme } from './support/theme';

const labels: Record<Theme, string> = { system: 'System', light: 'Light##theme', dark: 'Dark' };

/** Select for the page's theme. */
export function ThemeSelect() {
  const [theme, setTheme] = useState(storedTheme);
  const choose = (next: Theme): void => {
    storeTheme(next);
    setTheme(next);
  };
  return (
    <Select
      class="inline-field"
      label={t('Theme')}
      value={theme}
      options={Object.entries(labels).map(([value, label]) => [value, t(label)])}
      onChange={(next) => choose(next as Theme)}
    />
  );
}
