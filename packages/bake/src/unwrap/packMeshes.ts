import { ChartPacker } from './ChartPacker';
import type { Charts } from './cutCharts';
import { type Packed, packLightmap } from './packLightmap';
import type { PackOptions, Unwrapped, UnwrappedMesh } from './UnwrapRequest';

/** Greatest share of a lightmap that charts, with half of their padding, may need for packing to be tried. */
const MOST_NEED = 1;

/**
 * Packs meshes into lightmaps, each mesh into one.
 *
 * @param surfaces - one per mesh; meshes with equal surfaces share one object
 * @param onProgress - called with the share of the work that is done
 * @throws Error when a lightmap is too small for the charts of one mesh
 */
export function packMeshes(
  surfaces: readonly Charts[],
  options: PackOptions,
  onProgress: (share: number) => void,
): Unwrapped {
  const groups = options.texelsPerMetre === null ? [surfaces.map((_, i) => i)] : groupsOf(surfaces, options);
  const meshes: UnwrappedMesh[] = [];
  const texelsPerMetre: number[] = [];
  let done = 0;
  // a group that does not fit passes some of its meshes to the next group
  for (let group = groups.shift(); group; group = groups.shift()) {
    const packed = packGroup(surfaces, group, options);
    if (packed) {
      const lightmap = texelsPerMetre.push(packed.texelsPerMetre) - 1;
      for (const [i, mesh] of packed.meshes.entries()) meshes[group[i]] = { lightmap, ...mesh };
      done += group.length;
    } else {
      const kept = Math.min(group.length - 1, Math.ceil(0.95 * group.length));
      groups.unshift(group.slice(0, kept), [...group.slice(kept), ...(groups.shift() ?? [])]);
    }
    onProgress(done / surfaces.length);
  }
  return { meshes, texelsPerMetre };
}

/** Groups surfaces into lightmaps by the texels that each needs. */
function groupsOf(surfaces: readonly Charts[], { size, padding, texelsPerMetre }: PackOptions): number[][] {
  const needs = new Map(
    [...new Set(surfaces)].map((each) => [each, new ChartPacker([each], size, padding).need(texelsPerMetre!)]),
  );
  const groups: number[][] = [];
  let room = 0;
  surfaces.forEach((surface, i) => {
    const need = needs.get(surface)!;
    if (groups.length === 0 || need > room) {
      groups.push([]);
      room = MOST_NEED;
    }
    groups.at(-1)!.push(i);
    room -= need;
  });
  return groups;
}

function packGroup(surfaces: readonly Charts[], group: readonly number[], options: PackOptions): Packed | null {
  const own = group.map((i) => surfaces[i]);
  const packed = packLightmap(own, options);
  if (packed || (group.length > 1 && options.texelsPerMetre !== null)) return packed;
  // a single mesh that does not fit gets a lower density
  const coarser = options.texelsPerMetre === null ? null : packLightmap(own, { ...options, texelsPerMetre: null });
  if (coarser) return coarser;
  const charts = own.reduce((sum, { charts: of }) => sum + new Set(of).size, 0);
  throw new Error(
    `A lightmap of ${options.size} texels is too small for ${charts} charts: ` +
      'choose a larger size, less padding, or texelsPerMetre, which takes several lightmaps.',
  );
}
