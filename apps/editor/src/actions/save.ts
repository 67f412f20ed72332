import { fileSave } from 'browser-fs-access';
import type { Editor } from '../Editor';
import type { Action } from './Action';

/** What the file dialogs of open and save offer. */
export const fileType = {
  id: 'farol-scene',
  description: 'Farol scene',
  mimeTypes: ['application/json'],
  extensions: ['.json'],
};

/** A name that every system takes for a file. */
const fileNameOf = (name: string): string =>
  `${name.replaceAll(/[^\p{L}\p{N} _-]+/gu, '').trim() || 'Scene'}.farol.json`;

async function write(editor: Editor, handle: FileSystemFileHandle | null): Promise<void> {
  const blob = new Blob([editor.serialize()], { type: 'application/json' });
  const fileName = editor.file.name ?? fileNameOf(editor.document.scene.name);
  // the picker gives the file; a browser without one downloads, and gives none
  const saved = await fileSave(blob, { ...fileType, mimeTypes: [...fileType.mimeTypes], fileName }, handle);
  editor.file = { name: saved?.name ?? fileName, handle: saved };
  editor.notices.show('info', `Saved ${editor.file.name}`);
}

export const save: Action = {
  id: 'file.save',
  label: 'Save',
  keys: ['Ctrl+S'],
  inFields: true,
  icon: 'save',
  run: (editor) => write(editor, editor.file.handle),
};

export const saveAs: Action = {
  id: 'file.save-as',
  label: 'Save as…',
  keys: ['Ctrl+Shift+S'],
  inFields: true,
  run: (editor) => write(editor, null),
};
