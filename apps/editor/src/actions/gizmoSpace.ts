import type { Action } from '../api/Action';

export const gizmoSpace: Action = {
  id: 'gizmo.space',
  label: ({ viewport }) =>
    viewport.space === 'local' ? "Handles along the object's axes" : "Handles along the world's axes",
  keys: ['X'],
  icon: 'local',
  run({ viewport }) {
    viewport.space = viewport.space === 'local' ? 'world' : 'local';
  },
  checked: ({ viewport }) => viewport.space === 'local',
};
