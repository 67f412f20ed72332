import { t } from '@farol/editing';
import { useState } from 'preact/hooks';
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
    <label class="inline-field">
      {t('Theme')}
      <select value={theme} onChange={({ currentTarget }) => choose(currentTarget.value as Theme)}>
        {Object.entries(labels).map(([value, label]) => (
          <option key={value} value={value}>
            {t(label)}
          </option>
        ))}
      </select>
    </label>
  );
}
