import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import type { PasteOptions } from '../model/clip';
import type { Container } from '../model/commands/Placement';
import type { EditorDocument } from '../model/EditorDocument';
import { deleteObjects } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

type ClipCode = typeof import('../model/clip');

/** Code for copying and pasting, fetched after the first frame; null until then. */
let clipCode: ClipCode | null = null;

const loadClipCode = async (): Promise<ClipCode> => (clipCode ??= await import('../model/clip'));

/**
 * Copies the selected objects: at once, or when the copying code is fetched.
 * @param copied - called with the objects once they were copied
 */
function copySelection(
  { document, clipboard }: EditorApi,
  copied: (objects: readonly GameObject[]) => void = () => {},
): unknown {
  const { scene, selectedObjects } = document;
  const put = ({ copyObjects }: ClipCode): void => {
    // objects may have been deleted while the code was fetched
    const objects = selectedObjects.filter((object) => scene.findById(object.id) === object);
    if (scene !== document.scene || objects.length === 0) return;
    const { text, files } = copyObjects(scene, objects);
    clipboard.put(text, files);
    copied(objects);
  };
  return clipCode ? put(clipCode) : clipboard.expect(loadClipCode().then(put));
}

/**
 * Pastes copied objects below a parent. Files and scripts that the scene lacks are read first.
 * @param where - called once everything is read; returns the parent, and moves the copies
 */
function pasteClip(
  editor: EditorApi,
  where: (document: EditorDocument) => { readonly parent: Container; readonly place?: PasteOptions['place'] },
): unknown {
  const { document, commands, clipboard } = editor;
  const { scene } = document;
  if (clipboard.coming || !clipCode) {
    return Promise.all([loadClipCode(), clipboard.coming]).then(() =>
      scene === document.scene ? pasteClip(editor, where) : undefined,
    );
  }
  const { assetsOfClip, isAssetThere, pasteObjects } = clipCode;
  const { text } = clipboard;
  if (!clipboard.hasObjects || text === null) return undefined;
  const run = (read?: PasteOptions['read']): void => {
    const { parent, place } = where(document);
    commands.run(pasteObjects(scene, text, parent, document.selection.ids, { read, place }));
  };
  const assets = assetsOfClip(text);
  if (assets.every((each) => isAssetThere(scene, each))) return run();
  return import('../files/readClipAssets').then(async ({ readClipAssets }) => {
    const read = await readClipAssets(editor, assets);
    if (scene === document.scene) run(read);
  });
}

export const copy: Action = {
  id: 'edit.copy',
  label: 'Copy',
  keys: ['Ctrl+C'],
  icon: 'copy',
  run: (editor) => copySelection(editor),
  enabled: hasSelection,
};

export const cut: Action = {
  id: 'edit.cut',
  label: 'Cut',
  keys: ['Ctrl+X'],
  icon: 'cut',
  run: (editor) =>
    copySelection(editor, (objects) => editor.commands.run(deleteObjects(editor.document.scene, objects))),
  enabled: hasSelection,
};

/** Pastes next to the last selected object, below the same parent, or at the top of the tree. */
export const paste: Action = {
  id: 'edit.paste',
  label: 'Paste',
  keys: ['Ctrl+V'],
  icon: 'paste',
  run: (editor) =>
    pasteClip(editor, ({ scene, selectedObjects }) => ({ parent: selectedObjects.at(-1)?.parent ?? scene })),
  enabled: ({ clipboard }) => clipboard.hasObjects,
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

/** Pastes as children of the last selected object, or at the top of the tree. */
export const pasteBelow: Action = {
  id: 'edit.paste-below',
  label: 'Paste below the selected object',
  keys: ['Ctrl+Shift+V'],
  icon: 'paste',
  run: (editor) => pasteClip(editor, ({ scene, selectedObjects }) => ({ parent: selectedObjects.at(-1) ?? scene })),
  enabled: (editor) => editor.clipboard.hasObjects && hasSelection(editor),
};
