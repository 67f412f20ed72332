import { ChartPacker } from './ChartPacker';
import type { Charts } from './cutCharts';
import type { UnwrappedMesh } from './UnwrapRequest';

/** Meshes of one lightmap, with their texel density. */
export interface Packed {
  /** Resulting density, after charts were rounded to whole texels. */
  readonly texelsPerMetre: number;
  /** Meshes in the order of the given surfaces. */
  readonly meshes: readonly Omit<UnwrappedMesh, 'lightmap'>[];
}

/** Share of a lightmap that charts typically fill when packed, including half of their padding. */
const NEED = 0.93;
/** Greatest share of the lightmap that charts with half of their padding may need; with more, packing is not tried. */
const MOST_NEED = 1.25;
/** Factor between consecutive densities (texels per metre) in the search for the highest one. */
const STEP = 1.04;
const MOST_STEPS = 60;

/**
 * Packs the charts of meshes into one lightmap.
 *
 * @param surfaces - one per mesh; meshes with equal surfaces share one object
 * @param texelsPerMetre - null: the highest that fits
 * @returns null when the lightmap is too small
 */
export function packLightmap(
  surfaces: readonly Charts[],
  { size, padding, texelsPerMetre }: { size: number; padding: number; texelsPerMetre: number | null },
): Packed | null {
  const packer = new ChartPacker(surfaces, size, padding);
  const fits = texelsPerMetre === null ? packFinest(packer, size, surfaces) : packer.pack(texelsPerMetre);
  if (!fits) return null;
  const meshes = surfaces.map(({ index, sourceVertex }, i) => ({ uv1: packer.uv1Of(i), index, sourceVertex }));
  return { texelsPerMetre: size * Math.sqrt(coveredArea(meshes) / totalArea(surfaces)), meshes };
}

const totalArea = (surfaces: readonly Charts[]): number => surfaces.reduce((sum, { area }) => sum + area, 0);

/** Share of the lightmap's area that charts cover. */
function coveredArea(meshes: Packed['meshes']): number {
  let area = 0;
  for (const { uv1, index } of meshes) {
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [2 * index[i], 2 * index[i + 1], 2 * index[i + 2]];
      const [ux, uy, vx, vy] = [uv1[b] - uv1[a], uv1[b + 1] - uv1[a + 1], uv1[c] - uv1[a], uv1[c + 1] - uv1[a + 1]];
      area += 0.5 * Math.abs(ux * vy - uy * vx);
    }
  }
  return area;
}

/** Packs at nearly the highest density that fits. @returns false when charts do not fit at any density */
function packFinest(packer: ChartPacker, size: number, surfaces: readonly Charts[]): boolean {
  if (packer.need(0) > MOST_NEED) return false;
  let scale = size / Math.sqrt(totalArea(surfaces));
  for (let i = 0; i < 4; i++) scale *= Math.sqrt(Math.min(1, NEED / packer.need(scale)));
  let best = 0;
  if (packer.pack(scale)) {
    for (let step = 0; step < MOST_STEPS && ((best = scale), packer.pack((scale *= STEP))); step++);
  } else {
    for (let step = 0; step < MOST_STEPS && best === 0; step++) if (packer.pack((scale /= STEP))) best = scale;
    if (best === 0) return packer.pack(0);
  }
  const between = best * Math.sqrt(STEP);
  return packer.pack(between) || packer.pack(best);
}
