import { t } from '@farol/editing';
import type { Action } from '../api/Action';

export const snap: Action = {
  id: 'gizmo.snap',
  label({ preferences, viewport }) {
    if (viewport.snapTo === 'surface') return t('Snap to surfaces (hold Ctrl for once)');
    if (viewport.snapTo === 'vertex') return t('Snap to vertices (hold Ctrl for once)');
    const { translate, rotate, scale } = preferences.getState().snapSteps;
    return t('Snap: {translate} m, {rotate}°, {scale} (hold Ctrl for once)', { translate, rotate, scale });
  },
  icon: 'magnet',
  menu: { menu: 'edit', group: 'handles', submenu: 'Handles' },
  run({ viewport }) {
    viewport.snapping = !viewport.snapping;
  },
  checked: ({ viewport }) => viewport.snapping,
};
