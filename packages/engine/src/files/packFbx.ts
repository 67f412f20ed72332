import type { FileMap } from '../assets/collectFiles';
import type { PackedObj } from './obj/PackedObj';

/**
 * Packs an FBX (binary or text, version 7.0 or later) and its textures into one GLB, from which it is read as any model is:
 * meshes, skeletons, morph targets, clips, lights and cameras, in metres. Textures are those inside the file, or are found
 * beside it as those of an OBJ are; how materials are mapped stands at `gltfOfMtl`. What is missing or left out is told.
 *
 * @param path - of the .fbx among the files
 * @param signal - cancels the work
 * @throws Error (as a rejection) of one sentence that says what is wrong with it; what the signal was aborted with
 */
export async function packFbx(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const { fbxToGlb } = await import('./fbx/fbxToGlb');
  return fbxToGlb(files, path, signal);
}
