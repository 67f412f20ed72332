import type { FileMap } from '../assets/collectFiles';
import type { PackedObj } from './obj/PackedObj';

/**
 * Packs an OBJ, its MTL files and their textures (PNG, JPEG, TGA, and other formats of the browser) into one GLB, which
 * is then read like any model. Textures are found even if case, slashes or folders differ; missing ones are listed in
 * `notes`. Missing normals are computed, by a crease angle of 30°. Groups become meshes; `gltfOfMtl` says how materials
 * are mapped. An STL or a PLY becomes one grey mesh likewise, with vertex colours if it has any. Runs in slices, so
 * that the page stays responsive.
 *
 * @param path - of the .obj, .stl or .ply among the files
 * @param signal - cancels the work
 * @throws Error (as a rejection) of one sentence that names the line and what to do; the signal's abort reason
 */
export async function packObj(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const { objToGlb } = await import('./obj/objToGlb');
  return objToGlb(files, path, signal);
}
