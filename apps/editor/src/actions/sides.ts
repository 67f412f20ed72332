import { Vector3 } from 'three';
import type { Action } from '../api/Action';

/** The sides that a scene is looked at from: name, and direction from the scene to the camera. */
export const sides = [
  ['right', [1, 0, 0]],
  ['left', [-1, 0, 0]],
  ['top', [0, 1, 0]],
  ['bottom', [0, -1, 0]],
  ['front', [0, 0, 1]],
  ['back', [0, 0, -1]],
] as const;

/** Looks from each side at the point that is orbited. */
export const lookFrom: readonly Action[] = sides.map(([side, direction]) => ({
  id: `view.${side}`,
  label: `Look from the ${side}`,
  menu: { menu: 'view', group: 'camera', submenu: 'Look from' },
  run({ viewport }) {
    viewport.lookThrough = null;
    viewport.editorCamera.lookFrom(new Vector3(...direction));
    viewport.invalidate();
  },
}));
