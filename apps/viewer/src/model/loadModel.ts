import {
  checkModel,
  checkModelFile,
  expandZips,
  modelError,
  packGltf,
  packObj,
  readGltfJson,
} from '@farol/engine/files';
import { shortText, t } from '@farol/editing';
import { LoadingManager, type WebGLRenderer } from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import type { FileMap } from '@farol/engine/files';
import { createLoader } from './createLoader';
import { findModel, lookUp, missingFiles, resolveUri } from './findModel';

export interface LoadedModel {
  name: string;
  gltf: GLTF;
  /** Sentences on missing or ignored parts, with the name of the file and the remedy. */
  notes: readonly string[];
  /** Packs the model and the files that it names into one GLB. */
  pack(): Promise<Blob>;
}

/**
 * Reads the glTF, OBJ, STL or PLY among some files, with the buffers, materials and textures that it names.
 *
 * @param given - files; a ZIP is replaced by its content
 * @param signal - cancels the reading
 * @throws Error that names the file and the reason; the signal's reason when it is aborted
 */
export async function loadModel(given: FileMap, renderer: WebGLRenderer, signal?: AbortSignal): Promise<LoadedModel> {
  const files = await expandZips(given);
  const path = findModel(files);
  try {
    return await (/\.(glb|gltf)$/i.test(path) ? loadGltf : loadMesh)(files, path, renderer, signal);
  } catch (error) {
    signal?.throwIfAborted();
    const { name, message } = error instanceof Error ? error : { name: '', message: String(error) };
    const why =
      name === 'NotReadableError'
        ? t('the browser cannot read it: it has more than 2 GB, or it was moved or changed; choose it again.')
        : message;
    throw new Error(`${shortText(path, 80)}: ${why}`, { cause: error });
  }
}

type Load = (files: FileMap, path: string, renderer: WebGLRenderer, signal?: AbortSignal) => Promise<LoadedModel>;

const toBlob = (glb: ArrayBuffer): Blob => new Blob([glb], { type: 'model/gltf-binary' });

const loadMesh: Load = async (files, path, renderer, signal) => {
  const { glb, notes } = await packObj(files, path, signal);
  const gltf = await parse(glb, readGltfJson(glb).extensionsUsed ?? [], path, files, renderer, signal);
  return { name: files.get(path)!.name, gltf, notes, pack: async () => toBlob(glb) };
};

const loadGltf: Load = async (files, path, renderer, signal) => {
  const file = files.get(path)!;
  const bytes = await file.arrayBuffer();
  const json = readGltfJson(bytes);
  const find = (uri: string): File | null => {
    const target = resolveUri(path, uri);
    return target === null ? null : lookUp(files, target);
  };
  checkModelFile(bytes, json, (uri) => find(uri)?.size ?? null);
  const missing = missingFiles(files, path, json);
  if (missing.length > 0) {
    const names = missing.slice(0, 8).map((each) => shortText(each, 60));
    throw new Error(
      t('it needs {names}: drop the whole folder, or all of its files together.', { names: names.join(', ') }),
    );
  }
  const gltf = await parse(bytes, json.extensionsUsed ?? [], path, files, renderer, signal);
  const pack = async (): Promise<Blob> => {
    if (/\.glb$/i.test(path)) return file;
    return toBlob(await packGltf(bytes, async (uri) => (await find(uri)?.arrayBuffer()) ?? null));
  };
  return { name: file.name, gltf, notes: [], pack };
};

async function parse(
  bytes: ArrayBuffer,
  extensions: readonly string[],
  path: string,
  files: FileMap,
  renderer: WebGLRenderer,
  signal?: AbortSignal,
): Promise<GLTF> {
  const manager = new LoadingManager();
  const blobs = new Map<File, string>();
  manager.setURLModifier((url) => {
    const target = resolveUri(path, url);
    const file = target === null ? null : lookUp(files, target);
    if (!file) return url;
    if (!blobs.has(file)) blobs.set(file, URL.createObjectURL(file));
    return blobs.get(file)!;
  });
  const { loader, dispose } = await createLoader(extensions, manager, renderer);
  try {
    signal?.throwIfAborted();
    const gltf = await loader.parseAsync(bytes, '');
    signal?.throwIfAborted();
    await checkModel(gltf.scene, signal);
    return gltf;
  } catch (error) {
    signal?.throwIfAborted();
    throw modelError(error);
  } finally {
    dispose();
    for (const url of blobs.values()) URL.revokeObjectURL(url);
  }
}
