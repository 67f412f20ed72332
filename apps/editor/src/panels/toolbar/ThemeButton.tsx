import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';
import { usePreferences } from '../../ui/preferences';

const next = { system: 'dark', dark: 'light', light: 'system' } as const;

/** Goes through the themes: the system's, dark, light. */
export function ThemeButton(): ReactNode {
  const theme = usePreferences((preferences) => preferences.theme);
  return (
    <button
      type="button"
      className="button"
      aria-label={`Theme: ${theme}`}
      title={`Theme: ${theme}`}
      onClick={() => usePreferences.setState({ theme: next[theme] })}
    >
      <Icon name={theme === 'light' ? 'directional' : theme === 'dark' ? 'moon' : 'contrast'} />
    </button>
  );
}
