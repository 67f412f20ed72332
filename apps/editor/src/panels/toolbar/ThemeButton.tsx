import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { IconButton } from '../../ui/IconButton';
import { useEditor } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';

const next = { system: 'dark', dark: 'light', light: 'system' } as const;

const themeLabel = (theme: keyof typeof next): string =>
  ({ system: t('Theme: system'), dark: t('Theme: dark'), light: t('Theme: light') })[theme];

/** Cycles through the themes: the system's, dark, light. */
export function ThemeButton(): ReactNode {
  const { preferences } = useEditor();
  const theme = usePreferences(({ theme: chosen }) => chosen);
  return (
    <IconButton
      icon={theme === 'light' ? 'directional' : theme === 'dark' ? 'moon' : 'contrast'}
      size={16}
      className="button"
      label={themeLabel(theme)}
      onClick={() => preferences.setState({ theme: next[theme] })}
    />
  );
}
