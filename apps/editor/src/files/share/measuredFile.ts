import { containerContent, createId, type FileObject, writeContainer } from '@farol/engine/files';
import type { EditorApi } from '../../api/EditorApi';

/** The editor's camera, as an object of a scene file. */
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

/** The scene with its assets as a `.farol` file; the editor's camera is added when it has none. */
export async function measuredFile(editor: EditorApi): Promise<Uint8Array<ArrayBuffer>> {
  const { file, files } = containerContent(editor.document.scene);
  if (file.activeCamera === null) {
    const camera = editorsCamera(editor);
    file.objects.push(camera);
    file.activeCamera = camera.id;
  }
  return writeContainer({ file, files });
}
