import { createRandom } from '../base/createRandom';

const ease = (t: number): number => t * t * (3 - 2 * t);

/** Smooth noise from 0 to below 1 that repeats with period 1 in x and y; `cells` lattice points over a period. */
export function createNoise(cells: number, seed: number): (x: number, y: number) => number {
  const random = createRandom(seed);
  const lattice = Float32Array.from({ length: cells * cells }, random);
  const wrap = (i: number): number => ((i % cells) + cells) % cells;
  return (x, y) => {
    const [fx, fy] = [x * cells, y * cells];
    const [ix, iy] = [Math.floor(fx), Math.floor(fy)];
    const [tx, ty] = [ease(fx - ix), ease(fy - iy)];
    const [column, row] = [wrap(ix), wrap(iy)];
    const [x0, x1] = [column, column + 1 === cells ? 0 : column + 1];
    const [y0, y1] = [row * cells, row + 1 === cells ? 0 : (row + 1) * cells];
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
  return (x, y) => {
    let sum = 0;
    for (let i = 0; i < octaves; i++) sum += layers[i](x, y) * weights[i];
    return sum / total;
  };
}
