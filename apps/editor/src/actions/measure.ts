import type { Action } from '../api/Action';

/** Opens the current scene in the Lab, which measures techniques. */
export const measure: Action = {
  id: 'file.measure',
  label: 'Measure this scene',
  icon: 'gauge',
  menu: { menu: 'file', group: 'share' },
  run: async (editor) => (await import('../files/share/openInLab')).openInLab(editor),
};
