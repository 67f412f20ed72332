import { t } from '@farol/editing';
import type { EditorApi } from './EditorApi';
import type { IconName } from '../style/iconPaths';

/** Where an action stands in the bar of menus. */
export interface MenuPlace {
  readonly menu: 'file' | 'edit' | 'object' | 'view' | 'help';
  /** Actions of a group stand together, between lines; in the order of `actions/index.ts`. */
  readonly group: string;
  /** Label of a submenu, for actions of one kind. */
  readonly submenu?: string;
}

/** Something that the user can do, from a menu, a button or a key. */
export interface Action {
  /** Its name, such as 'edit.undo'. */
  readonly id: string;
  /** What menus and buttons say. */
  readonly label: string | ((editor: EditorApi) => string);
  /** Keys, such as 'Ctrl+Shift+Z'; the first one is shown. Ctrl is Command on a Mac. */
  readonly keys?: readonly string[];
  /** Whether the keys count while a text field has the focus. What was typed is taken over first. */
  readonly inFields?: boolean;
  readonly icon?: IconName;
  /** Every action is in a menu: those of plugins that name none are in a submenu of Edit. */
  readonly menu?: MenuPlace;
  run(editor: EditorApi): unknown;
  /** Whether it can be done now; always when absent. */
  enabled?(editor: EditorApi): boolean;
  /** For what is on or off: whether it is on. */
  checked?(editor: EditorApi): boolean;
}

/** What an action is called at present, in the language that is shown. A function's text is taken as it is. */
export function labelOf(action: Action, editor: EditorApi): string {
  return typeof action.label === 'string' ? t(action.label) : action.label(editor);
}
