import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';

async function write(editor: EditorApi, handle: FileSystemFileHandle | null): Promise<void> {
  const { writeScene } = await import('../files/writeScene');
  await writeScene(editor, handle);
}

export const save: Action = {
  id: 'file.save',
  label: 'Save',
  keys: ['Ctrl+S'],
  inFields: true,
  icon: 'save',
  menu: { menu: 'file', group: 'save' },
  run: (editor) => write(editor, editor.file.handle),
};

export const saveAs: Action = {
  id: 'file.save-as',
  label: 'Save as…',
  keys: ['Ctrl+Shift+S'],
  inFields: true,
  menu: { menu: 'file', group: 'save' },
  run: (editor) => write(editor, null),
};
