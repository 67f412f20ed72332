import { createRandom } from '../base/createRandom';

const ease = (t: number): number => t * t * (3 - 2 * t);

/** Smooth noise from 0 to below 1 that repeats with period 1 in x and y; `cells` lattice points over a period. */
export function createNoise(cells: number, seed: number): (x: number, y: number) => number {
  const random = createRandom(seed);
  const lattice = Float32Array.from({ length: cells * cells }, random);
  return (x, y) => {
    const ix = Math.floor(x * cells);
    const iy = Math.floor(y * cells);
    const tx = ease(x * cells - ix);
    const ty = ease(y * cells - iy);
    const x0 = ix - Math.floor(ix / cells) * cells;
    const y0 = (iy - Math.floor(iy / cells) * cells) * cells;
    const x1 = x0 + 1 === cells ? 0 : x0 + 1;
    const y1 = y0 + cells === lattice.length ? 0 : y0 + cells;
    const top = lattice[y0 + x0] * (1 - tx) + lattice[y0 + x1] * tx;
    const bottom = lattice[y1 + x0] * (1 - tx) + lattice[y1 + x1] * tx;
    return top * (1 - ty) + bottom * ty;
  };
}

/** Sum of octaves of noise, each at half the scale and `gain` times the amplitude of the last; from 0 to below 1. */
export function createFractalNoise(
  cells: number,
  octaves: number,
  seed: number,
  gain = 0.5,
): (x: number, y: number) => number {
  const layers = Array.from({ length: octaves }, (_, i) => createNoise(cells * 2 ** i, seed + i * 101));
  const weights = layers.map((_, i) => gain ** i);
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  return (x, y) => layers.reduce((sum, layer, i) => sum + layer(x, y) * weights[i], 0) / total;
}
