import type { Action } from '../api/Action';

export const exportScene: Action = {
  id: 'file.export',
  label: 'Export and share…',
  keys: ['Ctrl+Shift+E'],
  inFields: true,
  icon: 'assets',
  menu: { menu: 'file', group: 'share' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'export' }),
};

/** Opens the current scene in the Lab, which measures techniques. */
export const measure: Action = {
  id: 'file.measure',
  label: 'Measure this scene',
  icon: 'gauge',
  menu: { menu: 'file', group: 'share' },
  run: async (editor) => (await import('../files/share/openInLab')).openInLab(editor),
};
