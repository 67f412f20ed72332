import type { Action } from './Action';

export const snap: Action = {
  id: 'gizmo.snap',
  label: 'Snap: 0.5 m, 15°, 0.1 (hold Ctrl for once)',
  icon: 'magnet',
  run({ viewport }) {
    viewport.snapping = !viewport.snapping;
  },
  checked: ({ viewport }) => viewport.snapping,
};
