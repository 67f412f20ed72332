import type { FileMap } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import { makeEmptyScene } from '../model/makeEmptyScene';
import { dropOn, sceneAmong } from './dropOn';

/** Opens a scene among files; else starts an empty scene and places the files at the centre of the viewport. */
export async function startWith(editor: EditorApi, files: FileMap): Promise<void> {
  const hasScene = (await sceneAmong(files)) !== null;
  if (!hasScene) {
    if (!(await editor.mayLoseChanges())) return;
    editor.show(makeEmptyScene(editor.libraryForNext()), { name: null, handle: null });
  }
  await dropOn(editor, { asset: null, files }, { kind: 'tree', id: null });
  if (!hasScene && editor.document.selectedObjects.length > 0) editor.viewport.focus();
}
