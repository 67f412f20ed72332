import { t } from '@farol/editing';
import type { EditorApi } from './EditorApi';
import type { IconName } from '../style/iconPaths';

/** Place of an action in the menu bar. */
export interface MenuPlace {
  readonly menu: 'file' | 'edit' | 'object' | 'view' | 'help';
  /** Group between separators; `menuBar` has the built-in ones in order. */
  readonly group: string;
  /** Label of a submenu for similar actions. */
  readonly submenu?: string;
}

/** A command that the user can run from a menu, a button or a key. */
export interface Action {
  /** Unique name, such as 'edit.undo'. */
  readonly id: string;
  /** Text in menus and on buttons. */
  readonly label: string | ((editor: EditorApi) => string);
  /** Key combinations, such as 'Ctrl+Shift+Z'; menus show the first. Ctrl is Command on a Mac. */
  readonly keys?: readonly string[];
  /** Whether the keys work while a text field has the focus; the field is then committed first. */
  readonly inFields?: boolean;
  readonly icon?: IconName;
  /** Place in the menu bar; a plugin's action without one is in a submenu of Edit. Built-in ones get theirs from `menuBar`. */
  readonly menu?: MenuPlace;
  run(editor: EditorApi): unknown;
  /** Whether the action is available now; always when absent. */
  enabled?(editor: EditorApi): boolean;
  /** Whether a switch is on; absent for actions that are not switches. */
  checked?(editor: EditorApi): boolean;
}

/** Current label of an action, in the user's language. A function's result is used as it is. */
export function labelOf(action: Action, editor: EditorApi): string {
  return typeof action.label === 'string' ? t(action.label) : action.label(editor);
}
