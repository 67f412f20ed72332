import type { ToolInput } from '@farol/mcp/tools';
import { allActions } from '../actions';
import { type Action, labelOf } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { dialogOf } from './readTools';
import { findObjects } from './findObjects';

/** Commands that only the user can run, each with the reason and the alternative for an agent. */
const byHand: Readonly<Record<string, string>> = {
  'file.open': 'the browser asks the user for the file: ask them to open it.',
  'file.agent': 'the user alone decides on it.',
  'edit.duplicate-many': 'its settings are set by hand: use the tool duplicate_along.',
};

/** Longest wait for a command (ms): one that asks the user for a file may never end. */
const PATIENCE = 20_000;

const isAvailable = (action: Action, editor: EditorApi): boolean => action.enabled?.(editor) ?? true;

export function listActions(editor: EditorApi, { find = '' }: ToolInput<'list_actions'>): object {
  const asked = find.toLowerCase();
  return allActions(editor)
    .filter(({ id }) => !Object.hasOwn(byHand, id))
    .map((action) => ({
      id: action.id,
      name: labelOf(action, editor),
      ...(!isAvailable(action, editor) && { available: false }),
      ...(action.checked && { on: action.checked(editor) }),
    }))
    .filter(({ id, name }) => `${id}\n${name}`.toLowerCase().includes(asked));
}

/** Runs a command, as from the menu. @throws Error that says what to do, when it is not there or not available */
export async function runAction(editor: EditorApi, { id, objects }: ToolInput<'run_action'>): Promise<object> {
  const { document, dialogs, commands } = editor;
  const action = allActions(editor).find((each) => each.id === id);
  if (!action) {
    const word = id.split('.').at(-1) ?? id;
    const alike = allActions(editor)
      .filter((each) => each.id.includes(word))
      .map((each) => each.id);
    const mend = alike.length > 0 ? `; there is ${alike.slice(0, 5).join(', ')}` : '';
    throw new Error(`There is no command “${id}”${mend}. list_actions has all.`);
  }
  if (Object.hasOwn(byHand, id)) throw new Error(`“${labelOf(action, editor)}” cannot be run: ${byHand[id]}`);
  if (objects) document.selection.set(findObjects(document.scene, objects).map((object) => object.id));
  if (!isAvailable(action, editor)) {
    const hint = objects ? '' : ' Many need objects: name them.';
    throw new Error(`“${labelOf(action, editor)}” is not available now.${hint}`);
  }
  const before = commands.last;
  const name = labelOf(action, editor);
  let end = (): void => {};
  let timer: ReturnType<typeof setTimeout> | undefined;
  const asks = new Promise<string>((resolve) => {
    end = dialogs.changed.subscribe(() => {
      const { current } = dialogs;
      if (current && current.kind !== 'progress')
        resolve(`The dialog “${dialogOf(current)}” is open: the user answers it.`);
    });
    timer = setTimeout(() => resolve('It has not ended yet.'), PATIENCE);
  });
  try {
    const note = await Promise.race([Promise.resolve(action.run(editor)).then(() => null), asks]);
    const { last, undoLabel } = commands;
    return {
      ran: name,
      step: last === before ? null : undoLabel,
      ...(note !== null && { note }),
      ...(action.checked && { on: action.checked(editor) }),
      selected: document.selectedObjects.length,
    };
  } finally {
    clearTimeout(timer);
    end();
  }
}

/** Undoes or redoes steps of the history. */
export function goThroughHistory({ commands }: EditorApi, direction: 'undo' | 'redo', steps = 1): object {
  const done: string[] = [];
  for (let i = 0; i < steps; i++) {
    const label = direction === 'undo' ? commands.undoLabel : commands.redoLabel;
    if (label === null || !commands[direction]()) break;
    done.push(label);
  }
  if (done.length === 0) throw new Error(`There is nothing to ${direction}.`);
  const { undoLabel: undo, redoLabel: redo } = commands;
  return { [direction === 'undo' ? 'undone' : 'redone']: done, undo, redo };
}

export async function openScene(editor: EditorApi, { name }: ToolInput<'open_scene'>): Promise<object> {
  const isEmpty = name === 'empty';
  if (!isEmpty && !Object.hasOwn(editor.samples, name))
    throw new Error(`There is no sample “${name}”: there are empty, ${Object.keys(editor.samples).join(', ')}.`);
  const before = editor.document.scene;
  const { note } = (await runAction(editor, { id: isEmpty ? 'file.new' : `file.new.${name}` })) as { note?: string };
  if (editor.document.scene === before) throw new Error(note ?? 'The scene was not replaced.');
  const { scene } = editor.document;
  return { opened: scene.name, objects: scene.size };
}

export function playScene({ document: { simulation, scene } }: EditorApi, input: ToolInput<'play'>): object {
  const { do: what } = input;
  if (what !== 'play' && what !== 'step' && simulation.state === 'stopped')
    throw new Error('The scene is stopped: play it first.');
  simulation[what]();
  return { play: simulation.state, time: scene.time };
}
