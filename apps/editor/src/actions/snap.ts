import { usePreferences } from '../ui/preferences';
import type { Action } from './Action';

export const snap: Action = {
  id: 'gizmo.snap',
  label() {
    const { translate, rotate, scale } = usePreferences.getState().snapSteps;
    return `Snap: ${translate} m, ${rotate}°, ${scale} (hold Ctrl for once)`;
  },
  icon: 'magnet',
  run({ viewport }) {
    viewport.snapping = !viewport.snapping;
  },
  checked: ({ viewport }) => viewport.snapping,
};
