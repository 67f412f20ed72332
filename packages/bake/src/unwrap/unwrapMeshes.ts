import type { Charts } from './cutCharts';
import type { PackOptions, SurfaceToUnwrap, Unwrapped, UnwrapRequest } from './UnwrapRequest';

/** The two steps of unwrapping. */
export interface Unwrapper {
  cut(surface: SurfaceToUnwrap): Promise<Charts>;
  /** @param surfaces - charts; `meshes` has the index of one for each mesh */
  pack(
    surfaces: readonly Charts[],
    meshes: readonly number[],
    options: PackOptions,
    onProgress: (share: number) => void,
  ): Promise<Unwrapped>;
}

/** Share of the progress that cutting into charts counts for. */
const CUTTING = 0.7;

/**
 * Computes non-overlapping lightmap UVs: charts are cut once for equal meshes, all surfaces in parallel, and packed for
 * each mesh.
 *
 * @param onProgress - called with the share of the work that is done
 * @throws Error when a lightmap is too small for the charts of one mesh
 */
export async function unwrapMeshes(
  { surfaces, meshes, ...options }: UnwrapRequest,
  { cut, pack }: Unwrapper,
  onProgress: (share: number) => void,
): Promise<Unwrapped> {
  let done = 0;
  const charts = await Promise.all(
    surfaces.map(async (surface) => {
      const found = await cut(surface);
      onProgress((CUTTING * ++done) / surfaces.length);
      return found;
    }),
  );
  return pack(charts, meshes, options, (share) => onProgress(CUTTING + (1 - CUTTING) * share));
}
