import { importModel } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addObject } from '../model/edits';

/** Puts the parts of a model into the scene, each an object that can be edited. */
export async function placeUnpacked(editor: EditorApi, name: string): Promise<void> {
  const { document, commands, viewport } = editor;
  await document.assets.load(name);
  const object = importModel(document.assets.model(name), document.assets, name);
  object.name = name.replace(/\.\w+$/, '');
  object.transform.position = viewport.editorCamera.target.toArray();
  commands.run(addObject(document.scene, object, document.scene, document.selection.ids));
}
