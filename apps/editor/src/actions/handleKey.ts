import type { EditorApi } from '../api/EditorApi';
import type { Action } from '../api/Action';
import { isComposing } from '@farol/editing';
import { allActions } from './allActions';
import { matchKey } from './matchKey';

/** What the focus is in. A menu or a list takes letters as text does: they choose what begins with them. */
type Focus = 'page' | 'text';

/** What a key goes to, innermost first: also what is in an open shadow root, whose host alone is the event's target. */
const elementsOf = (event: KeyboardEvent): Element[] =>
  event.composedPath().filter((each): each is Element => each instanceof Element);

const isWithin = (elements: readonly Element[], selector: string): boolean =>
  elements.some((each) => each.matches(selector));

function focusOf(elements: readonly Element[]): Focus {
  const [target] = elements;
  if (!(target instanceof HTMLElement)) return 'page';
  if (isWithin(elements, '[role="menu"], [role="listbox"], [role="dialog"], [role="alertdialog"]')) return 'text';
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return 'text';
  if (!(target instanceof HTMLInputElement)) return 'page';
  if (['checkbox', 'radio', 'button', 'range'].includes(target.type)) return 'page';
  // a number takes letters too: units, π, functions
  return 'text';
}

/** What the space bar belongs to while it has the focus. */
const PRESSABLE = 'button, a, input, select, summary, [role="tab"], [role="treeitem"], [role="option"]';

/** What is walked through, or set, by the arrow keys, Home, End and the pages while it has the focus. */
const WALKED = 'input, select, [role="slider"], [role="tab"], [role="treeitem"], [role="option"], [role="separator"]';
const WALKS = new Set(['End', 'Home', 'PageUp', 'PageDown', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight']);

const counts = (action: Action, focus: Focus): boolean => focus === 'page' || (action.inFields ?? false);

/** Whether what has the focus does this itself: a code editor has a history of its own. See `data-own-actions`. */
function isOwnKey(elements: readonly Element[], action: Action): boolean {
  const owner = elements.find((each) => each.matches('[data-own-actions]')) as HTMLElement | undefined;
  return owner?.dataset.ownActions?.split(' ').includes(action.id) ?? false;
}

/** An action that a key does, and by which combination; one that the layout types comes before one by the key's place. */
function* actionsOf(editor: EditorApi, event: KeyboardEvent): Generator<readonly [Action, string]> {
  for (const isTyped of [true, false]) {
    for (const action of allActions(editor)) {
      const combination = editor.keys.keysOf(action).find((keys) => matchKey(keys, event, isTyped));
      if (combination !== undefined) yield [action, combination];
    }
  }
}

/**
 * Does the action of a key.
 * @param isCapture - before the focused element hears of the key: only actions that count in every place, which no menu
 * that is just closing shall swallow; else those that count where the focus is: none while keys go to a scene that plays,
 * but Escape, which gives them back
 * @returns whether there is one; nobody else shall do anything with the key then
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
    takeOverField(elements[0]);
    if (action.enabled?.(editor) ?? true) editor.attempt(() => action.run(editor));
    return true;
  }
  return false;
}

/** A text field gives its value when it loses the focus: what was typed shall count before the action does. */
function takeOverField(target: Element | undefined): void {
  if (!(target instanceof HTMLElement)) return;
  const isInput = target instanceof HTMLInputElement && !['checkbox', 'radio'].includes(target.type);
  if (!isInput && !target.isContentEditable) return;
  target.blur();
  target.focus();
}
