import { checkModel, checkModelFile, modelError, readGltfJson } from '@farol/engine/files';
import { LoadingManager, type WebGLRenderer } from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import type { FileMap } from '@farol/engine/files';
import { createLoader } from './createLoader';
import { findModel, lookUp, missingFiles, resolveUri } from './findModel';

/** A model that was read whole. */
export interface LoadedModel {
  /** Name of its file. */
  name: string;
  gltf: GLTF;
}

/**
 * Reads the glTF among some files, with the buffers and textures that it names.
 *
 * @param signal cancels the reading
 * @throws Error that names the file and the reason; nothing is shown half then; what the signal was aborted with
 */
export async function loadModel(files: FileMap, renderer: WebGLRenderer, signal?: AbortSignal): Promise<LoadedModel> {
  const path = findModel(files);
  const file = files.get(path)!;
  try {
    const bytes = await file.arrayBuffer();
    const json = readGltfJson(bytes);
    checkModelFile(bytes, json, (uri) => {
      const target = resolveUri(path, uri);
      return target === null ? null : (lookUp(files, target)?.size ?? null);
    });
    const missing = missingFiles(files, path, json);
    if (missing.length > 0) {
      throw new Error(
        `it needs ${missing.slice(0, 8).join(', ')}: drop the whole folder, or all of its files together.`,
      );
    }
    return { name: file.name, gltf: await parse(bytes, json.extensionsUsed ?? [], path, files, renderer, signal) };
  } catch (error) {
    signal?.throwIfAborted();
    throw new Error(`${path}: ${error instanceof Error ? error.message : String(error)}`, { cause: error });
  }
}

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
