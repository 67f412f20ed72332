import { GameObject } from '@farol/engine';
import { beforeEach, expect, it, vi } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { Clipboard } from '../model/Clipboard';
import { EditorDocument } from '../model/EditorDocument';
import type * as clipboardActions from './clipboard';

let actions: typeof clipboardActions;

// the copying code is fetched anew in each test
beforeEach(async () => {
  vi.resetModules();
  actions = await import('./clipboard');
});

/** An editor with a selected lamp. */
function makeEditor(): { editor: EditorApi; document: EditorDocument; names: () => string[] } {
  const document = new EditorDocument();
  const lamp = new GameObject('Lamp');
  document.scene.add(lamp);
  document.selection.set([lamp.id]);
  const editor = { document, commands: document.commands, clipboard: new Clipboard() } as unknown as EditorApi;
  return { editor, document, names: () => document.scene.roots.map(({ name }) => name) };
}

it('pastes what was copied just before, while the code of copies is still fetched', async () => {
  const { editor, names } = makeEditor();
  expect(actions.paste.enabled!(editor)).toBe(false);
  const copied = actions.copy.run(editor);
  expect(actions.paste.enabled!(editor)).toBe(true);
  const pasted = actions.paste.run(editor);
  expect(names()).toEqual(['Lamp']);
  await Promise.all([copied, pasted]);
  expect(names()).toEqual(['Lamp', 'Lamp 2']);
  // the code is fetched by now: actions run at once
  actions.paste.run(editor);
  expect(names()).toEqual(['Lamp', 'Lamp 2', 'Lamp 3']);
});

it('cuts what was selected then, but for what has gone since', async () => {
  const { editor, document, names } = makeEditor();
  const chair = new GameObject('Chair');
  document.scene.add(chair);
  document.selection.set([...document.selection.ids, chair.id]);
  const cut = actions.cut.run(editor);
  document.selection.clear();
  document.scene.remove(chair);
  await cut;
  expect(names()).toEqual([]);
  await actions.paste.run(editor);
  expect(names()).toEqual(['Lamp']);
});

it('copies nothing once another scene is there', async () => {
  const { editor, document } = makeEditor();
  const copied = actions.copy.run(editor);
  document.open(new EditorDocument().scene);
  await copied;
  expect(editor.clipboard.hasObjects).toBe(false);
});
