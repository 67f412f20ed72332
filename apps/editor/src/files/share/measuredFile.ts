import { containerContent, createId, type FileObject, writeContainer } from '@farol/engine/files';
import type { EditorApi } from '../../api/EditorApi';

/** The camera of the editor, as an object of a scene. */
function editorsCamera({ viewport }: EditorApi): FileObject {
  const { position, rotation } = viewport.camera;
  const place = { position: position.toArray(), rotation: [rotation.x, rotation.y, rotation.z] as const };
  const component = (type: string, values: object) => ({ type, version: 1, id: createId(), values });
  return {
    id: createId(),
    name: 'Camera',
    parent: null,
    components: [component('Transform', place), component('Camera', {})] as FileObject['components'],
  };
}

/** The scene as it is, with its assets, as a `.farol` file; seen by the editor's camera where it has none of its own. */
export async function measuredFile(editor: EditorApi): Promise<Uint8Array<ArrayBuffer>> {
  const { file, files } = containerContent(editor.document.scene);
  if (file.activeCamera === null) {
    const camera = editorsCamera(editor);
    file.objects.push(camera);
    file.activeCamera = camera.id;
  }
  return writeContainer({ file, files });
}
