import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { Preferences } from '../api/preferences';
import { MAIN_PANEL } from '../layout/LayoutNode';

/** Focuses a panel once it is rendered. */
function focusPanel(id: string): void {
  requestAnimationFrame(() => document.getElementById(`panel-${id}`)?.focus());
}

/** Id of the panel whose tab or content has the focus. */
function focusedPanel(): string | null {
  const place = document.activeElement?.closest('[role="tabpanel"], [role="tab"]');
  return place?.id.replace(/^(panel|tab)-/, '') ?? null;
}

/** Focuses the next or previous visible panel; after the last one comes the first. */
function goRound(by: 1 | -1): void {
  const shown = [...document.querySelectorAll('.dock-panel:not([hidden])')].map(({ id }) => id.replace('panel-', ''));
  const at = shown.indexOf(focusedPanel() ?? '');
  const next = at < 0 ? (by > 0 ? 0 : shown.length - 1) : (at + by + shown.length) % shown.length;
  if (shown[next]) focusPanel(shown[next]);
}

export const nextPanel: Action = {
  id: 'panels.next',
  label: 'Go to the next panel',
  keys: ['F6'],
  inFields: true,
  run: () => goRound(1),
};

export const previousPanel: Action = {
  id: 'panels.previous',
  label: 'Go to the panel before',
  keys: ['Shift+F6'],
  inFields: true,
  run: () => goRound(-1),
};

export const maximiseViewport: Action = {
  id: 'panels.maximise',
  label: 'Maximise the viewport',
  keys: ['Space'],
  icon: 'maximise',
  run: ({ layout }) => layout.maximise(layout.maximised() === null ? 'viewport' : null),
  checked: ({ layout }) => layout.maximised() !== null,
};

/** Makes the focused panel fill the window, or restores the layout. */
export const maximisePanel: Action = {
  id: 'panels.maximise-focused',
  label: 'Maximise the panel',
  keys: ['Shift+Space'],
  icon: 'maximise',
  run: ({ layout }) => layout.maximise(layout.maximised() === null ? (focusedPanel() ?? MAIN_PANEL) : null),
};

export const resetPanels: Action = {
  id: 'panels.reset',
  label: 'Reset the panels',
  icon: 'panels',
  run: ({ layout }) => layout.reset(),
};

/** One action for each panel: shows and focuses it, or closes it when it is in front. */
export const showPanels = ({ panels }: EditorApi): Action[] =>
  panels.list.map(({ id, title, icon }) => ({
    id: `panels.show.${id}`,
    label: title,
    icon,
    run({ layout }) {
      if (layout.isInFront(id)) layout.close(id);
      else {
        layout.open(id);
        focusPanel(id);
      }
    },
    checked: ({ layout }) => layout.isOpen(id),
  }));

export const goToMenuBar: Action = {
  id: 'panels.menu-bar',
  label: 'Go to the menus',
  keys: ['F10'],
  inFields: true,
  run: () => document.querySelector<HTMLElement>('.menu-bar [role="menuitem"], button.menu-bar')?.focus(),
};

const labels = [
  ['system', "The system's theme"],
  ['dark', 'Dark theme'],
  ['light', 'Light theme'],
] as const satisfies readonly (readonly [Preferences['theme'], string])[];

export const themes: readonly Action[] = labels.map(([theme, label]) => ({
  id: `view.theme.${theme}`,
  label,
  run: ({ preferences }) => preferences.setState({ theme }),
  checked: ({ preferences }) => preferences.getState().theme === theme,
}));
