import { checkInput, type Content, type Edit, edits, type ToolInput, type ToolName } from '@farol/mcp/tools';
import type { EditorApi } from '../api/EditorApi';
import { goThroughHistory, listActions, openScene, playScene, runAction } from './actionTools';
import { runBatch, runEdits } from './editTools';
import { describeType, getLights, getMessages, getObjects, getScene } from './readTools';
import { takeScreenshot } from './screenshot';

/** Maximum length of an answer (characters). */
const MOST_LETTERS = 4_000_000;

type EditName = keyof typeof edits;
type Runner<Name extends ToolName> = (editor: EditorApi, input: ToolInput<Name>, client: string) => unknown;

/** Runner of each tool except single edits, which run as batches of one. */
const runners: { readonly [Name in Exclude<ToolName, EditName>]: Runner<Name> } = {
  get_scene: getScene,
  get_objects: getObjects,
  describe_type: describeType,
  get_lights: getLights,
  screenshot: takeScreenshot,
  get_messages: getMessages,
  save_text: (editor) => editor.serialize(),
  list_actions: listActions,
  batch: runBatch,
  run_action: runAction,
  undo: (editor, { steps }) => goThroughHistory(editor, 'undo', steps),
  redo: (editor, { steps }) => goThroughHistory(editor, 'redo', steps),
  open_scene: openScene,
  play: playScene,
};

/**
 * Runs a tool of an agent.
 * @param input - the tool's input as the agent sent it, unchecked
 * @throws Error (as a rejection) that names the thing and the remedy; an edit has then changed nothing
 */
export async function runTool(
  editor: EditorApi,
  tool: string,
  input: unknown,
  client: string,
): Promise<readonly Content[]> {
  const checked = checkInput(tool, input ?? {});
  const { name } = checked;
  const result = Object.hasOwn(edits, name)
    ? await runEdits(editor, [{ ...(checked.input as object), edit: name } as Edit], client)
    : await (runners[name as Exclude<ToolName, EditName>] as Runner<ToolName>)(editor, checked.input as never, client);
  if (Array.isArray(result) && name === 'screenshot') return result as Content[];
  const text = typeof result === 'string' ? result : JSON.stringify(result);
  if (text.length > MOST_LETTERS) throw new Error(`The answer would have ${text.length} characters: narrow the call.`);
  return [{ type: 'text', text }];
}
