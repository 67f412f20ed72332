/** What the mouse, and keys that are no actions, do. */
export const otherKeys: readonly (readonly [string, string])[] = [
  ['Left button', 'Select; drag: orbit'],
  ['Middle button, or Shift and left', 'Pan'],
  ['Wheel', 'Nearer and farther; while flying: speed'],
  ['Right button', 'Click: a menu; drag: look around; with W A S D Q E: fly, Shift: faster'],
  ['Left button in Select, or with Ctrl', 'Drag: select what is in the box; with Ctrl: more of it'],
  ['Ctrl while dragging a handle', 'Snap'],
  ['Fingers', 'Tap: select; one: orbit; two: pan, nearer and farther; a long press: a menu'],
  ['Arrow keys in the picture', 'Orbit; with Shift: pan; + and -: nearer and farther'],
  ['Ctrl+Shift+D in the tree', 'Move objects by the arrow keys; Enter: put them there'],
  ['Arrow keys in a number', 'Step; with Shift: ten times, with Alt: a tenth'],
  ['Alt+Shift+arrow key on a tab', 'Move the panel; Delete: close it'],
  ['Esc, then Tab, in the code', 'Leave the code editor'],
];
