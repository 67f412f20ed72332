import { type Action, labelOf } from './Action';
import type { EditorApi } from './EditorApi';
import type { IconName } from '../style/iconPaths';

/** A command in a menu. */
export interface MenuCommand {
  readonly label: string;
  readonly help?: string;
  readonly icon?: IconName;
  /** Key combination shown at the right. */
  readonly keys?: string;
  readonly disabled?: boolean;
  /** Whether a switch is on; absent for entries that are not switches. */
  readonly checked?: boolean;
  run(): void;
}

/** An entry of a menu: a command, a submenu, or a separator. */
export type MenuEntry =
  | MenuCommand
  | { readonly label: string; readonly icon?: IconName; readonly entries: readonly MenuEntry[] }
  | 'separator';

/** The menu entry of an action. */
export function actionEntry(action: Action, editor: EditorApi): MenuEntry {
  return {
    label: labelOf(action, editor),
    icon: action.icon,
    keys: editor.keys.keysOf(action).at(0),
    checked: action.checked?.(editor),
    disabled: !(action.enabled?.(editor) ?? true),
    run: () => editor.attempt(() => action.run(editor)),
  };
}
