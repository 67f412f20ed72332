import { createRandom } from '../../base/createRandom';

const SIZE = 256;
const random = createRandom(7);
const lattice = Float32Array.from({ length: SIZE * SIZE }, () => random());

/** Value noise: from 0 to 1, smooth, the same in every run. */
function noise(x: number, y: number): number {
  const column = Math.floor(x);
  const row = Math.floor(y);
  const fx = x - column;
  const fy = y - row;
  const sx = fx * fx * (3 - 2 * fx);
  const sy = fy * fy * (3 - 2 * fy);
  const left = column & (SIZE - 1);
  const right = (left + 1) & (SIZE - 1);
  const upper = (row & (SIZE - 1)) * SIZE;
  const lower = ((row + 1) & (SIZE - 1)) * SIZE;
  const top = lattice[upper + left] + (lattice[upper + right] - lattice[upper + left]) * sx;
  const bottom = lattice[lower + left] + (lattice[lower + right] - lattice[lower + left]) * sx;
  return top + (bottom - top) * sy;
}

/** Fractal noise of some octaves: from 0 to 1, about 0.5 on average. */
export function cloudNoise(x: number, y: number, octaves: number): number {
  let sum = 0;
  let weight = 0.5;
  let total = 0;
  for (let i = 0; i < octaves; i++) {
    sum += weight * noise(x, y);
    total += weight;
    weight *= 0.5;
    // each octave is rotated, so that the lattices of the octaves do not coincide
    const turned = 1.6 * x - 1.2 * y + 17.3;
    y = 1.2 * x + 1.6 * y + 5.9;
    x = turned;
  }
  return sum / total;
}
