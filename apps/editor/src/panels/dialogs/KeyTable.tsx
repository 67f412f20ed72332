import type { ReactNode } from 'react';
import { actions } from '../../actions';
import { labelOf } from '../../actions/Action';
import { useEditor } from '../../ui/EditorContext';
import { keyText } from '../../ui/keyText';

/** What the mouse, and keys that are no actions, do. */
const others: readonly (readonly [string, string])[] = [
  ['Left button', 'Select; drag: orbit'],
  ['Middle button, or Shift and left', 'Pan'],
  ['Wheel', 'Nearer and farther; while flying: speed'],
  ['Right button', 'Look around; with W A S D Q E: fly, Shift: faster'],
  ['Ctrl while dragging a handle', 'Snap'],
  ['Arrow keys in the picture', 'Orbit; with Shift: pan; + and -: nearer and farther'],
  ['Ctrl+Shift+D in the tree', 'Move objects by the arrow keys; Enter: put them there'],
  ['Arrow keys in a number', 'Step; with Shift: ten times, with Alt: a tenth'],
];

/** Every key, from the actions themselves. */
export function KeyTable(): ReactNode {
  const editor = useEditor();
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a list that scrolls must be reachable by keys
    <dl className="keys" tabIndex={0} aria-label="All keys">
      {actions
        .filter(({ keys }) => keys)
        .map((action) => (
          <div key={action.id}>
            <dt>
              {action.keys!.map((key) => (
                <kbd key={key}>{keyText(key)}</kbd>
              ))}
            </dt>
            <dd>{labelOf(action, editor)}</dd>
          </div>
        ))}
      {others.map(([keys, what]) => (
        <div key={keys}>
          <dt>{keys}</dt>
          <dd>{what}</dd>
        </div>
      ))}
    </dl>
  );
}
