import type { EditorApi } from '../api/EditorApi';
import type { Action } from '../api/Action';
import { isComposing } from '@farol/editing';
import { allActions } from '.';
import { matchKey } from './matchKey';

/** Kind of the focused element. Menus and lists count as text: letters choose the entries that begin with them. */
type Focus = 'page' | 'text';

/**
 * Elements that a key event passes, innermost first, including those in open shadow roots (the event's target is only
 * their host).
 */
const elementsOf = (event: KeyboardEvent): Element[] =>
  event.composedPath().filter((each): each is Element => each instanceof Element);

const isWithin = (elements: readonly Element[], selector: string): boolean =>
  elements.some((each) => each.matches(selector));

function focusOf(elements: readonly Element[]): Focus {
  const [target] = elements;
  if (!(target instanceof HTMLElement)) return 'page';
  // the popup of a field is open, but has not taken the focus yet
  if (target.matches('[aria-haspopup][aria-expanded="true"]')) return 'text';
  if (isWithin(elements, '[role="menu"], [role="listbox"], [role="dialog"], [role="alertdialog"]')) return 'text';
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return 'text';
  if (!(target instanceof HTMLInputElement)) return 'page';
  if (['checkbox', 'radio', 'button', 'range'].includes(target.type)) return 'page';
  // number fields accept letters too: units, π, functions
  return 'text';
}

/** Selector of elements that use the space bar themselves. */
const PRESSABLE = 'button, a, input, select, summary, [role="tab"], [role="treeitem"], [role="option"]';

/** Selector of elements that use arrow keys, Home, End or Page keys themselves. */
const WALKED = 'input, select, [role="slider"], [role="tab"], [role="treeitem"], [role="option"], [role="separator"]';
const WALKS = new Set(['End', 'Home', 'PageUp', 'PageDown', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight']);

/** Controls that keep focus after use: Escape only takes their focus; within a tool's form it ends the tool. */
const FIELD = 'input, .field, [role="checkbox"], [role="combobox"], [role="slider"]';

const counts = (action: Action, focus: Focus): boolean => focus === 'page' || (action.inFields ?? false);

/** Whether the focused element handles an action itself, as a code editor with its own undo does; see `data-own-actions`. */
function isOwnKey(elements: readonly Element[], action: Action): boolean {
  const owner = elements.find((each) => each.matches('[data-own-actions]')) as HTMLElement | undefined;
  return owner?.dataset.ownActions?.split(' ').includes(action.id) ?? false;
}

/** Actions of a key, with the matching combination: first by the typed character, then by the key's position. */
function* actionsOf(editor: EditorApi, event: KeyboardEvent): Generator<readonly [Action, string]> {
  for (const isTyped of [true, false]) {
    for (const action of allActions(editor)) {
      const combination = editor.keys.keysOf(action).find((keys) => matchKey(keys, event, isTyped));
      if (combination !== undefined) yield [action, combination];
    }
  }
}

/**
 * Runs the action of a key.
 * @param isCapture - whether the event is in its capture phase: then only actions that work everywhere run, so that a
 *   closing menu does not swallow the key. In the bubbling phase the other actions run, if the focused element allows
 *   them; while a playing scene gets the keys, only Escape is handled, and gives the keys back
 * @returns whether an action was found, in which case other handlers must ignore the key
 */
export function handleKey(editor: EditorApi, event: KeyboardEvent, isCapture: boolean): boolean {
  if (event.defaultPrevented || isComposing(event) || editor.dialogs.current) return false;
  if (editor.viewport.keysGoToScene && !isCapture) {
    if (event.key !== 'Escape') return false;
    editor.viewport.input.giveKeysBack();
    return true;
  }
  const elements = elementsOf(event);
  const focus = focusOf(elements);
  for (const [action, combination] of actionsOf(editor, event)) {
    if ((action.inFields ?? false) !== isCapture || !counts(action, focus)) continue;
    if (isOwnKey(elements, action)) continue;
    if (combination === 'Space' && isWithin(elements, PRESSABLE)) continue;
    if (WALKS.has(combination) && isWithin(elements, WALKED)) continue;
    if (combination === 'Escape' && isWithin(elements, FIELD) && !isWithin(elements, 'form')) {
      (elements[0] as HTMLElement).blur();
      return true;
    }
    takeOverField(elements[0]);
    if (action.enabled?.(editor) ?? true) editor.attempt(() => action.run(editor));
    return true;
  }
  return false;
}

/** Commits a text field, which gives its value on blur, before the action runs. */
function takeOverField(target: Element | undefined): void {
  if (!(target instanceof HTMLElement)) return;
  const isInput = target instanceof HTMLInputElement && !['checkbox', 'radio'].includes(target.type);
  if (!isInput && !target.isContentEditable) return;
  target.blur();
  target.focus();
}
