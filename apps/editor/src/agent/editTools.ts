import { namesOf, t, tCount } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { Edit, ToolInput } from '@farol/mcp/tools';
import type { EditorApi } from '../api/EditorApi';
import { Sequence } from '../model/commands/Sequence';
import { readableText } from '../model/readableText';
import { prepareEdit, type PreparedEdit } from './editCommands';
import { pathOf } from './findObjects';

/** Maximum number of objects in an answer. */
const MOST_LISTED = 60;

/** Name of the step in the history. */
function labelOf(edits: readonly Edit[], client: string): string {
  if (edits.length > 1) return tCount(edits.length, '{client}: {count} edit', '{client}: {count} edits', { client });
  const [edit] = edits;
  if (edit.edit === 'add_object') return t('{client} added {name}', { client, name: edit.name ?? edit.what });
  const names = 'objects' in edit ? edit.objects : [edit.object];
  const name = readableText(namesOf(names.map((each) => ({ name: each }))));
  return edit.edit === 'delete'
    ? t('{client} deleted {name}', { client, name })
    : t('{client} edited {name}', { client, name });
}

/**
 * Makes edits as one step of the history: all, or none.
 * @throws Error (as a rejection) that names the edit and the remedy
 */
export async function runEdits(
  editor: EditorApi,
  edits: readonly Edit[],
  client: string,
  label?: string,
): Promise<object> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const prepared: PreparedEdit[] = [];
  /** Names the edit that an error is about. */
  const told = (i: number, error: unknown): Error => {
    const text = error instanceof Error ? error.message : String(error);
    return edits.length > 1
      ? new Error(`Edit ${i + 1} (${edits[i].edit}): ${text} Nothing was changed.`)
      : new Error(text);
  };
  for (const [i, edit] of edits.entries()) {
    try {
      prepared.push(await prepareEdit(editor, edit));
    } catch (error) {
      throw told(i, error);
    }
  }
  if (scene !== document.scene) throw new Error('Another scene was opened meanwhile: nothing was changed.');
  const step = label === undefined ? labelOf(edits, client) : `${client}: ${label}`;
  let current = 0;
  const make = prepared.flatMap(({ make }, i) =>
    make.map((each) => () => {
      current = i;
      return each();
    }),
  );
  const before = selection.ids;
  try {
    commands.run(new Sequence(step, make));
  } catch (error) {
    throw told(current, error);
  }
  const touched = [...new Set(prepared.flatMap((each) => each.touched()))].filter(
    ({ scene: holder }) => holder === scene,
  );
  // as after an edit by hand: what was added is selected
  const added = edits.some(({ edit }) => edit === 'add_object' || edit === 'duplicate_along');
  selection.set(added ? touched.map(({ id }) => id) : before.filter((id) => scene.findById(id)));
  return {
    done: step,
    objects: touched.slice(0, MOST_LISTED).map(listed),
    ...(touched.length > MOST_LISTED && { more: touched.length - MOST_LISTED }),
    ...(document.simulation.state !== 'stopped' && { note: 'The scene plays: stopping it undoes this edit.' }),
  };
}

const listed = (object: GameObject): object => ({ id: object.id, path: pathOf(object) });

export const runBatch = (editor: EditorApi, { edits, label }: ToolInput<'batch'>, client: string): Promise<object> =>
  runEdits(editor, edits, client, label);
