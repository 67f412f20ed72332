import { t } from '@farol/editing';
import { type View, views } from '@farol/renderer';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';

/** English name of a debug view. */
export const englishViewLabel = (view: View): string =>
  view.charAt(0).toUpperCase() + view.slice(1).replaceAll('-', ' ');

/** Name of a debug view, in the user's language. */
export const viewLabel = (view: View): string => t(englishViewLabel(view));

export const techniqueActions = ({ viewport: { farol } }: EditorApi): Action[] =>
  Object.entries(farol.techniques).map(([name, { label }]) => ({
    id: `technique.${name}`,
    label,
    icon: 'lamp',
    menu: { menu: 'view', group: 'picture', submenu: 'Technique' },
    run({ viewport }) {
      viewport.technique = name as typeof viewport.technique;
    },
    checked: ({ viewport }) => viewport.technique === name,
  }));

export const viewActions: readonly Action[] = views.map((view) => ({
  id: `shown.${view}`,
  label: englishViewLabel(view),
  icon: 'eye',
  menu: { menu: 'view', group: 'picture', submenu: 'Show' },
  run({ viewport }) {
    viewport.view = view;
  },
  checked: ({ viewport }) => viewport.view === view,
}));
