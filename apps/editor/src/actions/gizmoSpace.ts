import type { Action } from '../api/Action';

export const gizmoSpace: Action = {
  id: 'gizmo.space',
  label: "Handles along the object's axes, not the world's",
  keys: ['X'],
  icon: 'local',
  menu: { menu: 'edit', group: 'handles', submenu: 'Handles' },
  run({ viewport }) {
    viewport.space = viewport.space === 'local' ? 'world' : 'local';
  },
  checked: ({ viewport }) => viewport.space === 'local',
};
