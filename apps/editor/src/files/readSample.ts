import { t } from '@farol/editing';
import type { AssetLibrary, Scene } from '@farol/engine';
import { deserialize, readSceneFile } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';

/**
 * Reads a sample's scene file from the editor's own site. @param assets - receives its assets @throws Error (as a
 * rejection) when it cannot be read
 */
export async function readSample(editor: EditorApi, file: string, assets: AssetLibrary): Promise<Scene> {
  const response = await fetch(new URL(`scenes/${file}`, document.baseURI));
  if (!response.ok) {
    const { status } = response;
    throw new Error(t('The sample {file} could not be read: the server answered {status}.', { file, status }));
  }
  const { text, fileOf } = await readSceneFile(new Uint8Array(await response.arrayBuffer()), editor.mayUnpack);
  const registry = editor.document.scripts.withoutScripts(editor.components);
  return deserialize(text, { assets, registry, fileOf });
}
