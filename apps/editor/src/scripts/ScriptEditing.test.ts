import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { addScript } from '../model/scriptEdits';
import { scriptTemplate } from '../model/scriptTemplate';
import { hasSyntaxErrors, ScriptEditing } from './ScriptEditing';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A document with two scripts that do not run. */
function scripts(): { document: EditorDocument; editing: ScriptEditing; source(name?: string): string } {
  const document = new EditorDocument();
  document.scripts.isOn = false;
  for (const name of ['A', 'B']) document.commands.run(addScript(document.scene, name).command);
  const editing = new ScriptEditing(document);
  return { document, editing, source: (name = 'A') => document.assets.fieldAsset(name)!.get('source') as string };
}

const good = 'export const one = 1;\n';
const better = 'export const one = 2;\n';
const broken = 'export const one = (;\n';

it('reads texts of TypeScript and of JavaScript', () => {
  expect(hasSyntaxErrors(scriptTemplate('A'), false)).toBe(false);
  expect(hasSyntaxErrors(scriptTemplate('A.js'), true)).toBe(false);
  expect(hasSyntaxErrors(scriptTemplate('A'), true)).toBe(true);
  expect(hasSyntaxErrors(broken, false)).toBe(true);
});

it('takes over what can be read once no more keys follow, as one step', () => {
  const { document, editing, source } = scripts();
  editing.edit('A', good);
  expect(source()).toBe(scriptTemplate('A'));
  expect(editing.textOf('A')).toBe(good);
  vi.advanceTimersByTime(200);
  expect(source()).toBe(good);
  expect(document.commands.history).toHaveLength(2);
  editing.edit('A', better);
  vi.advanceTimersByTime(200);
  editing.finish();
  expect(document.commands.history).toEqual(['Made script A', 'Made script B', 'Edited script A']);
  document.commands.undo();
  expect(editing.textOf('A')).toBe(scriptTemplate('A'));
  document.commands.redo();
  expect(editing.textOf('A')).toBe(better);
});

it('keeps the last good text while what is typed cannot be read, and loses nothing', () => {
  const { document, editing, source } = scripts();
  editing.edit('A', good);
  vi.advanceTimersByTime(200);
  editing.edit('A', broken);
  vi.advanceTimersByTime(200);
  expect(editing.isBroken('A')).toBe(true);
  expect(source()).toBe(good);
  expect(editing.textOf('A')).toBe(broken);
  // leaving the script, or saving, commits the broken text
  editing.finish();
  expect(source()).toBe(broken);
  expect(editing.isBroken('A')).toBe(true);
  expect(document.commands.history.at(-1)).toBe('Edited script A');
  document.commands.undo();
  expect(source()).toBe(scriptTemplate('A'));
  expect(editing.isBroken('A')).toBe(false);
});

it('makes a step of each script, and none of a text that is as it was', () => {
  const { document, editing, source } = scripts();
  editing.edit('A', good);
  editing.edit('B', better);
  editing.finish();
  expect([source('A'), source('B')]).toEqual([good, better]);
  expect(document.commands.history.slice(2)).toEqual(['Edited script A', 'Edited script B']);
  editing.edit('B', good);
  vi.advanceTimersByTime(200);
  editing.edit('B', better);
  editing.finish();
  expect(document.commands.history).toHaveLength(4);
});

it('drops a draft of a text that changed elsewhere, or of a script that is gone', () => {
  const { document, editing, source } = scripts();
  editing.edit('A', good);
  editing.finish();
  editing.edit('A', broken);
  vi.advanceTimersByTime(200);
  document.commands.undo();
  expect(editing.textOf('A')).toBe(scriptTemplate('A'));
  editing.edit('B', good);
  document.commands.undo();
  expect(editing.names).toEqual(['A']);
  vi.advanceTimersByTime(200);
  editing.finish();
  expect(source()).toBe(scriptTemplate('A'));
  expect(document.commands.redoLabel).toBe('Made script B');
});
