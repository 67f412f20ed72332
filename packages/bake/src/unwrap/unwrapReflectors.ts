import type { CheckedBakeOptions } from '../checkOptions';
import type { StaticMesh } from '../scene/StaticMesh';
import type { UnwrappedMesh } from './UnwrapRequest';
import { unwrapStaticMeshes } from './unwrapStaticMeshes';

/** Factor by which lightmaps are coarser that serve the bake alone. */
const COARSER = 4;

/** Meshes that reflect light without a lightmap of their own: each copy is one. */
export interface Reflectors {
  readonly meshes: readonly StaticMesh[];
  readonly unwrapped: readonly (UnwrappedMesh | null)[];
  /** Texels per metre, one number per lightmap; these lightmaps serve the bake and are not kept. */
  readonly texelsPerMetre: readonly number[];
}

/** Each instance of an instanced mesh, as a mesh of its own. */
const copiesOf = (mesh: StaticMesh): StaticMesh[] =>
  mesh.placements.map((placement, i) => ({
    ...mesh,
    placements: [placement],
    colours: mesh.colours && [mesh.colours[i]],
    isLit: true,
  }));

/**
 * Lays out meshes that reflect light without a lightmap that is kept, in one lightmap more, coarsely. Where there is no
 * room for them they cast shadows alone, which is told.
 *
 * @param density - texels a metre of the lightmaps that are kept
 * @param first - number of the first lightmap
 */
export async function unwrapReflectors(
  meshes: readonly StaticMesh[],
  density: number,
  first: number,
  options: CheckedBakeOptions,
): Promise<Reflectors> {
  const copies = meshes.flatMap(copiesOf);
  if (copies.length === 0) return { meshes: [], unwrapped: [], texelsPerMetre: [] };
  const coarse = { ...options, padding: 1, onWarning: () => {} };
  try {
    const wanted = { ...coarse, texelsPerMetre: density / COARSER };
    let layout = await unwrapStaticMeshes(copies, wanted, () => {});
    if (layout.texelsPerMetre.length > 1)
      layout = await unwrapStaticMeshes(copies, { ...coarse, texelsPerMetre: undefined }, () => {});
    const unwrapped = layout.unwrapped.map((each) => each && { ...each, lightmap: each.lightmap + first });
    return { meshes: copies, unwrapped, texelsPerMetre: layout.texelsPerMetre };
  } catch (error) {
    options.signal?.throwIfAborted();
    const names = [...new Set(meshes.map(({ name }) => name))].join(', ');
    options.onWarning(`These reflect no light: ${names}. ${(error as Error).message}`);
    return { meshes, unwrapped: meshes.map(() => null), texelsPerMetre: [] };
  }
}
