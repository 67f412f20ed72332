import type { Scene } from '@farol/engine';
import type { FileAsset } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import { nameInScene } from '../model/bringAssets';
import { assetsOfClip, copyObjects, isClip, pasteObjects, type PasteOptions } from '../model/clip';
import type { Container } from '../model/commands/Placement';
import type { EditorDocument } from '../model/EditorDocument';
import { deleteObjects } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

const copySelection = ({ document, clipboard }: EditorApi): void => {
  const { text, files } = copyObjects(document.scene, document.selectedObjects);
  clipboard.put(text, files);
};

/**
 * Pastes copied objects below a parent. Files and scripts that the scene lacks are read first.
 * @param where - called once everything is read
 */
function pasteClip(
  editor: EditorApi,
  where: (document: EditorDocument) => { readonly parent: Container; readonly place?: PasteOptions['place'] },
): unknown {
  const { document, commands, clipboard } = editor;
  const { scene } = document;
  const { text } = clipboard;
  if (!isClip(text)) return undefined;
  const run = (read?: PasteOptions['read']): void => {
    const { parent, place } = where(document);
    commands.run(pasteObjects(scene, text, parent, document.selection.ids, { read, place }));
  };
  const assets = assetsOfClip(text);
  if (assets.every((each) => isThere(scene, each))) return run();
  return import('../files/readClipAssets').then(async ({ readClipAssets }) => {
    const read = await readClipAssets(editor, assets);
    if (scene === document.scene) run(read);
  });
}

/** Whether an asset needs no reading: the scene has it, or it consists of fields and is no script. */
function isThere(scene: Scene, asset: FileAsset): boolean {
  const { name, type, values } = asset;
  if (values === undefined) return nameInScene(scene, asset) !== null;
  return type !== 'script' || scene.assets.fieldAsset(name)?.get('source') === values.source;
}

export const copy: Action = {
  id: 'edit.copy',
  label: 'Copy',
  keys: ['Ctrl+C'],
  icon: 'copy',
  menu: { menu: 'edit', group: 'clipboard' },
  run: copySelection,
  enabled: hasSelection,
};

export const cut: Action = {
  id: 'edit.cut',
  label: 'Cut',
  keys: ['Ctrl+X'],
  icon: 'cut',
  menu: { menu: 'edit', group: 'clipboard' },
  run(editor) {
    copySelection(editor);
    editor.commands.run(deleteObjects(editor.document.scene, editor.document.selectedObjects));
  },
  enabled: hasSelection,
};

/** Pastes beside the selected object, or at the top of the tree. */
export const paste: Action = {
  id: 'edit.paste',
  label: 'Paste',
  keys: ['Ctrl+V'],
  icon: 'paste',
  menu: { menu: 'edit', group: 'clipboard' },
  run: (editor) =>
    pasteClip(editor, ({ scene, selectedObjects }) => ({ parent: selectedObjects.at(-1)?.parent ?? scene })),
  enabled: ({ clipboard }) => isClip(clipboard.text),
};

/** Pastes at the top of the tree; the objects land at a page position (CSS pixels). */
export async function pasteAt(editor: EditorApi, at: { readonly x: number; readonly y: number }): Promise<void> {
  const { landingView, pointInPicture } = await import('../files/landInPicture');
  const { land } = await import('../viewport/placing/land');
  const point = pointInPicture(editor, at);
  await pasteClip(editor, ({ scene }) => ({
    parent: scene,
    place: (copies) => land(landingView(editor), copies, point),
  }));
}

/** Pastes below the selected object. */
export const pasteBelow: Action = {
  id: 'edit.paste-below',
  label: 'Paste below the selected object',
  keys: ['Ctrl+Shift+V'],
  icon: 'paste',
  menu: { menu: 'edit', group: 'clipboard' },
  run: (editor) => pasteClip(editor, ({ scene, selectedObjects }) => ({ parent: selectedObjects.at(-1) ?? scene })),
  enabled: (editor) => isClip(editor.clipboard.text) && hasSelection(editor),
};
