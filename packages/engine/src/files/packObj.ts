import type { FileMap } from '../assets/collectFiles';
import type { PackedObj } from './obj/PackedObj';

/**
 * Packs an OBJ, its MTL files and their textures (PNG, JPEG, TGA, and what else the browser decodes) into one GLB, from
 * which it is read as any model is. Textures are found by other case, backslashes and other folders too; those that are
 * missing are told, and are no error. Normals that are missing are computed by the crease angle of 30°. Groups become
 * meshes; how materials are mapped stands at `gltfOfMtl`. An STL or a PLY becomes one grey mesh in the same way, with the
 * colours of its vertices where it has any. The work is done in slices, so that the page answers.
 *
 * @param path - of the .obj, .stl or .ply among the files
 * @param signal - cancels the work
 * @throws Error (as a rejection) of one sentence that names the line and what to do; what the signal was aborted with
 */
export async function packObj(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const { objToGlb } = await import('./obj/objToGlb');
  return objToGlb(files, path, signal);
}
