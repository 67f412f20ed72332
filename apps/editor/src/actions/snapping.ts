import type { SnapTarget } from '../viewport/handles/DragSnap';
import type { GizmoPivot } from '../viewport/Gizmo';
import type { Action } from '../api/Action';

const targets: readonly [SnapTarget, string][] = [
  ['grid', 'Snap to steps'],
  ['surface', 'Snap to surfaces'],
  ['vertex', 'Snap to vertices'],
];

export const snapTargets: readonly Action[] = targets.map(([target, label]) => ({
  id: `gizmo.snap-${target}`,
  label,
  menu: { menu: 'edit', group: 'handles', submenu: 'Snapping' },
  run({ preferences, viewport }) {
    preferences.setState({ snapTo: target });
    viewport.snapping = true;
  },
  checked: ({ viewport }) => viewport.snapTo === target,
}));

export const alignToSurface: Action = {
  id: 'gizmo.snap-align',
  label: 'Turn along the surface',
  menu: { menu: 'edit', group: 'handles', submenu: 'Snapping' },
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
  menu: { menu: 'edit', group: 'handles', submenu: 'Pivot' },
  run: ({ preferences }) => preferences.setState({ pivot }),
  checked: ({ viewport }) => viewport.pivot === pivot,
}));
