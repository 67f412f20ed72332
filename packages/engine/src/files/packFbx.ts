import type { FileMap } from '../assets/collectFiles';
import type { PackedObj } from './obj/PackedObj';

/**
 * Packs an FBX (binary or text, version 7.0 or later) and its textures into one GLB, which is then read like any model:
 * meshes, skeletons, morph targets, clips, lights and cameras, in metres. Textures are embedded, or found as for an
 * OBJ; `gltfOfMtl` maps the materials. `notes` lists missing and omitted parts.
 *
 * @param path - of the .fbx among the files
 * @param signal - cancels the work
 * @throws Error (as a rejection) of one sentence that says what is wrong with the file; the signal's abort reason
 */
export async function packFbx(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const { fbxToGlb } = await import('./fbx/fbxToGlb');
  return fbxToGlb(files, path, signal);
}
