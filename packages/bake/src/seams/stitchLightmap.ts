import type { SurfaceToUnwrap, UnwrappedMesh } from '../unwrap/UnwrapRequest';
import { findSeams } from './findSeams';
import { SeamSystem } from './SeamSystem';

/** A lightmap whose seams are to be removed. */
export interface StitchRequest {
  readonly size: number;
  /** Irradiance, four floats per texel; texels around a chart have the light of its border. */
  readonly data: Float32Array;
  /** Meshes of the lightmap, with the surfaces that their charts were cut from. */
  readonly meshes: readonly { readonly surface: SurfaceToUnwrap; readonly unwrapped: UnwrappedMesh }[];
}

/**
 * Equalises light where charts cut a smooth surface, since bilinear filtering would show chart borders as lines.
 *
 * @returns `data`, changed in place
 */
export function stitchLightmap({ size, data, meshes }: StitchRequest): Float32Array {
  const system = new SeamSystem(size);
  /** Seams by the index array that equal meshes share. */
  const known = new Map<Uint32Array, Uint32Array>();
  for (const { surface, unwrapped } of meshes) {
    let seams = known.get(unwrapped.index);
    if (!seams) known.set(unwrapped.index, (seams = findSeams(surface, unwrapped)));
    const at = (vertex: number): readonly number[] => [unwrapped.uv1[2 * vertex], unwrapped.uv1[2 * vertex + 1]];
    for (let i = 0; i < seams.length; i += 4) {
      system.add(at(seams[i]), at(seams[i + 1]), at(seams[i + 2]), at(seams[i + 3]));
    }
  }
  system.solve(data);
  return data;
}
