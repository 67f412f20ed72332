import type { IconName } from '../style/iconPaths';
import type { GizmoMode } from '../viewport/Gizmo';
import type { Action } from '../api/Action';

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
  menu: { menu: 'edit', group: 'handles', submenu: 'Handles' },
  run({ viewport }) {
    viewport.mode = mode;
  },
  checked: ({ viewport }) => viewport.mode === mode,
}));
