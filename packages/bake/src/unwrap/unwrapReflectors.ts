import type { CheckedBakeOptions } from '../checkOptions';
import type { StaticMesh } from '../scene/StaticMesh';
import type { UnwrappedMesh } from './UnwrapRequest';
import { unwrapStaticMeshes } from './unwrapStaticMeshes';

/** Factor by which lightmaps that serve the bake alone have a lower density. */
const COARSER = 4;

/** Meshes that reflect light without a lightmap; each instance is one mesh. */
export interface Reflectors {
  readonly meshes: readonly StaticMesh[];
  readonly unwrapped: readonly (UnwrappedMesh | null)[];
  /** Texels per metre, one number per lightmap; these lightmaps serve the bake and are not kept. */
  readonly texelsPerMetre: readonly number[];
}

/** Splits an instanced mesh into one mesh per instance. */
const copiesOf = (mesh: StaticMesh): StaticMesh[] =>
  mesh.placements.map((placement, i) => ({
    ...mesh,
    placements: [placement],
    colours: mesh.colours && [mesh.colours[i]],
    isLit: true,
  }));

/**
 * Packs meshes that reflect light without a lightmap into one temporary lightmap of low density. If they do not fit,
 * they only cast shadows, with a warning.
 *
 * @param density - texels per metre of the final lightmaps
 * @param first - index of the first temporary lightmap
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
