import type { Preferences } from '../api/preferences';
import type { Action } from '../api/Action';

const labels = [
  ['system', "The system's theme"],
  ['dark', 'Dark theme'],
  ['light', 'Light theme'],
] as const satisfies readonly (readonly [Preferences['theme'], string])[];

export const themes: readonly Action[] = labels.map(([theme, label]) => ({
  id: `view.theme.${theme}`,
  label,
  menu: { menu: 'view', group: 'window', submenu: 'Theme' },
  run: ({ preferences }) => preferences.setState({ theme }),
  checked: ({ preferences }) => preferences.getState().theme === theme,
}));
