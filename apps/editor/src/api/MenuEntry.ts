import { type Action, labelOf } from './Action';
import type { EditorApi } from './EditorApi';
import type { IconName } from '../style/iconPaths';

/** One line of a menu: something to do, a submenu, or a line between groups. */
export type MenuEntry =
  | {
      readonly label: string;
      readonly help?: string;
      readonly icon?: IconName;
      /** Key shown at the right. */
      readonly keys?: string;
      readonly disabled?: boolean;
      /** For what is on or off: whether it is on. */
      readonly checked?: boolean;
      run(): void;
    }
  | { readonly label: string; readonly icon?: IconName; readonly entries: readonly MenuEntry[] }
  | 'separator';

/** The line of an action. */
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
