import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { copyObjects, isClip, pasteObjects } from '../model/clip';
import { deleteObjects } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

const copySelection = ({ document, clipboard }: EditorApi): void => {
  clipboard.text = copyObjects(document.scene, document.selectedObjects);
};

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

/** Beside what is selected, or at the top of the tree. */
export const paste: Action = {
  id: 'edit.paste',
  label: 'Paste',
  keys: ['Ctrl+V'],
  icon: 'paste',
  menu: { menu: 'edit', group: 'clipboard' },
  run({ document, commands, clipboard }) {
    const { scene, selection, selectedObjects } = document;
    const { text } = clipboard;
    if (isClip(text)) commands.run(pasteObjects(scene, text, selectedObjects.at(-1)?.parent ?? scene, selection.ids));
  },
  enabled: ({ clipboard }) => isClip(clipboard.text),
};

/** At the top of the tree, on what is seen at a point of the page (CSS pixels). */
export async function pasteAt(editor: EditorApi, at: { readonly x: number; readonly y: number }): Promise<void> {
  const { landingView, pointInPicture } = await import('../files/landInPicture');
  const { land } = await import('../viewport/placing/land');
  const { document, commands, clipboard } = editor;
  const { scene, selection } = document;
  const { text } = clipboard;
  if (!isClip(text)) return;
  const point = pointInPicture(editor, at);
  const place = (copies: readonly GameObject[]): void => land(landingView(editor), copies, point);
  commands.run(pasteObjects(scene, text, scene, selection.ids, place));
}

/** Below what is selected. */
export const pasteBelow: Action = {
  id: 'edit.paste-below',
  label: 'Paste below the selected object',
  keys: ['Ctrl+Shift+V'],
  icon: 'paste',
  menu: { menu: 'edit', group: 'clipboard' },
  run({ document, commands, clipboard }) {
    const { scene, selection, selectedObjects } = document;
    const { text } = clipboard;
    if (isClip(text)) commands.run(pasteObjects(scene, text, selectedObjects.at(-1) ?? scene, selection.ids));
  },
  enabled: (editor) => isClip(editor.clipboard.text) && hasSelection(editor),
};
