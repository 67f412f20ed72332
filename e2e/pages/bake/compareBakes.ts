import type { Bake } from '@farol/bake';
import { DataUtils } from 'three';
import { coveredTexels } from './coveredTexels';

/** How far the light of a bake is from that of another with the same charts, over the texels that charts cover. */
export interface BakeDifference {
  /** Peak signal to noise of irradiance in dB; the peak is the white below. */
  readonly linear: number;
  /** Difference as an eye sees it: coded as sRGB, clipped at white. */
  readonly coded: number;
  /** Irradiance that 99.9% of the reference's texels stay below. */
  readonly white: number;
  /** Mean of the bake by that of the reference, less 1. */
  readonly bias: number;
  readonly texels: number;
}

const coded = (value: number): number => (value < 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);

/** @throws Error when the two have other charts */
export function compareBakes(bake: Bake, reference: Bake): BakeDifference {
  bake.meshes.forEach(({ uv1 }, i) => {
    const other = reference.meshes[i]?.uv1;
    if (other?.length !== uv1.length || !uv1.every((value, k) => value === other[k]))
      throw new Error('The two bakes have other charts: their texels cannot be compared.');
  });
  const ours: number[] = [];
  const theirs: number[] = [];
  bake.lightmaps.forEach(({ data }, lightmap) => {
    const covered = coveredTexels(reference, lightmap);
    for (let texel = 0; texel < covered.length; texel++) {
      if (covered[texel] === 0) continue;
      for (let k = 4 * texel; k < 4 * texel + 3; k++) {
        ours.push(DataUtils.fromHalfFloat(data[k]));
        theirs.push(DataUtils.fromHalfFloat(reference.lightmaps[lightmap].data[k]));
      }
    }
  });
  const white = Float32Array.from(theirs).sort()[Math.floor(0.999 * (theirs.length - 1))];
  let [linear, display, sum, all] = [0, 0, 0, 0];
  ours.forEach((value, i) => {
    const other = theirs[i];
    linear += (value - other) ** 2;
    display += (coded(Math.min(1, value / white)) - coded(Math.min(1, other / white))) ** 2;
    sum += value;
    all += other;
  });
  const decibels = (error: number, peak: number): number => 10 * Math.log10((peak * peak * ours.length) / error);
  const bias = sum / all - 1;
  return { linear: decibels(linear, white), coded: decibels(display, 1), white, bias, texels: ours.length / 3 };
}
