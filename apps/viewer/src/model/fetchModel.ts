import { type Group, LoaderUtils, LoadingManager, type WebGLRenderer } from 'three';
import { createLoader } from './createLoader';
import { readGltfJson } from '@farol/engine/files';

/**
 * Reads a glTF and the files that it names from an address.
 *
 * @returns its scene
 * @throws Error (as a rejection) that names the address
 */
export async function fetchModel(url: string, renderer: WebGLRenderer): Promise<Group> {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} cannot be read: ${answer.status} ${answer.statusText}`);
  const bytes = await answer.arrayBuffer();
  const extensions = readGltfJson(bytes).extensionsUsed ?? [];
  const { loader, dispose } = await createLoader(extensions, new LoadingManager(), renderer);
  try {
    return (await loader.parseAsync(bytes, LoaderUtils.extractUrlBase(url))).scene;
  } finally {
    dispose();
  }
}
