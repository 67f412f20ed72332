import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';
import { useEditor } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';

const next = { system: 'dark', dark: 'light', light: 'system' } as const;

/** Goes through the themes: the system's, dark, light. */
export function ThemeButton(): ReactNode {
  const { preferences } = useEditor();
  const theme = usePreferences(({ theme: chosen }) => chosen);
  return (
    <button
      type="button"
      className="button"
      aria-label={`Theme: ${theme}`}
      title={`Theme: ${theme}`}
      onClick={() => preferences.setState({ theme: next[theme] })}
    >
      <Icon name={theme === 'light' ? 'directional' : theme === 'dark' ? 'moon' : 'contrast'} />
    </button>
  );
}
