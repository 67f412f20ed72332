import { t } from '@farol/editing';

/** Fixed functions of the mouse, and of keys that are not actions. */
export const otherKeys = (): [string, string][] => [
  [t('Left button'), t('Select; drag: orbit')],
  [t('Middle button, or Shift and left'), t('Pan')],
  [t('Wheel'), t('Nearer and farther; while flying: speed')],
  [t('Right button'), t('Click: a menu; drag: look around; with W A S D Q E: fly, Shift: faster')],
  [t('Left button in Select, or with Ctrl'), t('Drag: select what is in the box; with Ctrl: more of it')],
  [t('Ctrl while dragging a handle'), t('Snap')],
  [
    t('X, Y, Z while dragging a handle'),
    t('Only along that axis; with Shift along the other two; again: in all directions'),
  ],
  [t('Numbers while dragging a handle'), t('Set the amount; Tab: the next axis; Enter: keep it; Escape: put it back')],
  [t('Fingers'), t('Tap: select; one: orbit; two: pan, nearer and farther; a long press: a menu')],
  [t('Arrow keys in the picture'), t('Orbit; with Shift: pan; + and -: nearer and farther')],
  [t('Ctrl+Shift+D in the tree'), t('Move objects by the arrow keys; Enter: put them there')],
  [t('Arrow keys in a number'), t('Step; with Shift: ten times, with Alt: a tenth')],
  [t('Alt+Shift+arrow key on a tab'), t('Move the panel; Delete: close it')],
  [t('Arrow keys in the Timeline'), t('A frame; with Shift: ten, with Ctrl: the next key, with Alt: move keys')],
  [t('Wheel in the Timeline'), t('Nearer and farther; with Shift: scroll, or the values of curves')],
  [t('Alt while dragging keys'), t('Between frames')],
  [t('Esc, then Tab, in the code'), t('Leave the code editor')],
];
