import type { Action } from '../api/Action';

/** Switches between perspective and orthographic. */
export const toggleOrthographic: Action = {
  id: 'view.orthographic',
  label: 'Orthographic',
  keys: ['Numpad5'],
  icon: 'mesh',
  menu: { menu: 'view', group: 'side' },
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
  menu: { menu: 'view', group: 'side', submenu: 'Turn the view' },
  run({ viewport }) {
    viewport.editorCamera.orbit(azimuth * TURN, polar * TURN);
    viewport.invalidate();
  },
  enabled: ({ viewport }) => viewport.flightProblem === null,
});

/** Orbit the view by 15 degrees. */
export const turns: readonly Action[] = [
  turn('turnLeft', 'Turn the view left', 'Numpad4', -1, 0),
  turn('turnRight', 'Turn the view right', 'Numpad6', 1, 0),
  turn('turnUp', 'Turn the view up', 'Numpad8', 0, -1),
  turn('turnDown', 'Turn the view down', 'Numpad2', 0, 1),
];
