import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import type { IconName } from '../style/iconPaths';
import type { GizmoMode, GizmoPivot } from '../viewport/Gizmo';
import type { SnapTarget } from '../viewport/handles/DragSnap';

const modes: readonly [GizmoMode & IconName, string, string][] = [
  ['select', 'Select', 'Q'],
  ['translate', 'Move', 'W'],
  ['rotate', 'Rotate', 'E'],
  ['scale', 'Scale##verb', 'R'],
];

export const gizmoModes: readonly Action[] = modes.map(([mode, label, key]) => ({
  id: `gizmo.${mode}`,
  label,
  keys: [key],
  icon: mode,
  run({ viewport }) {
    viewport.mode = mode;
  },
  checked: ({ viewport }) => viewport.mode === mode,
}));

export const gizmoSpace: Action = {
  id: 'gizmo.space',
  label: "Handles along the object's axes, not the world's",
  keys: ['X'],
  icon: 'local',
  run({ viewport }) {
    viewport.space = viewport.space === 'local' ? 'world' : 'local';
  },
  checked: ({ viewport }) => viewport.space === 'local',
};

export const snap: Action = {
  id: 'gizmo.snap',
  label({ preferences, viewport }) {
    if (viewport.snapTo === 'surface') return t('Snap to surfaces (hold Ctrl for once)');
    if (viewport.snapTo === 'vertex') return t('Snap to vertices (hold Ctrl for once)');
    const { translate, rotate, scale } = preferences.getState().snapSteps;
    return t('Snap: {translate} m, {rotate}°, {scale} (hold Ctrl for once)', { translate, rotate, scale });
  },
  icon: 'magnet',
  run({ viewport }) {
    viewport.snapping = !viewport.snapping;
  },
  checked: ({ viewport }) => viewport.snapping,
};

const targets: readonly [SnapTarget, string][] = [
  ['grid', 'Snap to steps'],
  ['surface', 'Snap to surfaces'],
  ['vertex', 'Snap to vertices'],
];

export const snapTargets: readonly Action[] = targets.map(([target, label]) => ({
  id: `gizmo.snap-${target}`,
  label,
  run({ preferences, viewport }) {
    preferences.setState({ snapTo: target });
    viewport.snapping = true;
  },
  checked: ({ viewport }) => viewport.snapTo === target,
}));

export const alignToSurface: Action = {
  id: 'gizmo.snap-align',
  label: 'Turn along the surface',
  run: ({ preferences }) => preferences.setState(({ alignsToSurface }) => ({ alignsToSurface: !alignsToSurface })),
  checked: ({ viewport }) => viewport.alignsToSurface,
};

const pivots: readonly [GizmoPivot, string][] = [
  ['centre', 'Pivot in the middle of the selection'],
  ['each', 'Pivot in each object'],
  ['active', 'Pivot in the object selected last'],
];

export const gizmoPivots: readonly Action[] = pivots.map(([pivot, label]) => ({
  id: `gizmo.pivot-${pivot}`,
  label,
  run: ({ preferences }) => preferences.setState({ pivot }),
  checked: ({ viewport }) => viewport.pivot === pivot,
}));
