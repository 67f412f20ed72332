import { t } from '@farol/editing';
import { Vector3 } from 'three';
import type { Action } from '../api/Action';

/** Views of the scene along the axes: name, direction from the target to the camera, and key. */
export const sides = [
  ['right', [1, 0, 0], 'Numpad3'],
  ['left', [-1, 0, 0], 'Ctrl+Numpad3'],
  ['top', [0, 1, 0], 'Numpad7'],
  ['bottom', [0, -1, 0], 'Ctrl+Numpad7'],
  ['front', [0, 0, 1], 'Numpad1'],
  ['back', [0, 0, -1], 'Ctrl+Numpad1'],
] as const;

export type Side = (typeof sides)[number][0];

export function sideName(side: Side): string {
  switch (side) {
    case 'right':
      return t('right##side');
    case 'left':
      return t('left##side');
    case 'top':
      return t('top##side');
    case 'bottom':
      return t('bottom##side');
    case 'front':
      return t('front##side');
    case 'back':
      return t('back##side');
  }
}

const labels: Readonly<Record<Side, string>> = {
  right: 'Look from the right',
  left: 'Look from the left',
  top: 'Look from the top',
  bottom: 'Look from the bottom',
  front: 'Look from the front',
  back: 'Look from the back',
};

/** One action for each side: views the orbit target from there, orthographically until the user orbits. */
export const lookFrom: readonly Action[] = sides.map(([side, direction, key]) => ({
  id: `view.${side}`,
  label: labels[side],
  keys: [key],
  menu: { menu: 'view', group: 'side', submenu: 'Look from' },
  run({ viewport }) {
    viewport.lookThrough = null;
    viewport.editorCamera.lookFrom(new Vector3(...direction), true);
    viewport.viewChanged();
  },
}));
