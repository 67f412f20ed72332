import { t } from '@farol/editing';
import { Vector3 } from 'three';
import type { Action } from '../api/Action';

export const focus: Action = {
  id: 'view.focus',
  label: 'Focus on the selection',
  keys: ['F', 'NumpadDecimal'],
  run: ({ viewport }) => viewport.focus(),
  enabled: ({ viewport }) => viewport.flightProblem === null,
};

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
  run({ viewport }) {
    viewport.lookThrough = null;
    viewport.editorCamera.lookFrom(new Vector3(...direction), true);
    viewport.viewChanged();
  },
}));

/** Switches between perspective and orthographic. */
export const toggleOrthographic: Action = {
  id: 'view.orthographic',
  label: 'Orthographic',
  keys: ['Numpad5'],
  icon: 'mesh',
  run({ viewport }) {
    viewport.editorCamera.orthographic = !viewport.editorCamera.orthographic;
    viewport.viewChanged();
  },
  checked: ({ viewport }) => viewport.editorCamera.orthographic,
  enabled: ({ viewport }) => viewport.lookThrough === null,
};

/** Angle by which a key orbits the view (rad). */
const TURN = Math.PI / 12;

const turn = (id: string, label: string, key: string, azimuth: number, polar: number): Action => ({
  id: `view.${id}`,
  label,
  keys: [key],
  run({ viewport }) {
    viewport.editorCamera.orbit(azimuth * TURN, polar * TURN);
    viewport.invalidate();
  },
  enabled: ({ viewport }) => viewport.flightProblem === null,
});

/** Actions that orbit the view by 15 degrees. */
export const turns: readonly Action[] = [
  turn('turnLeft', 'Turn the view left', 'Numpad4', -1, 0),
  turn('turnRight', 'Turn the view right', 'Numpad6', 1, 0),
  turn('turnUp', 'Turn the view up', 'Numpad8', 0, -1),
  turn('turnDown', 'Turn the view down', 'Numpad2', 0, 1),
];
