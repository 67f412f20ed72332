/** Samples per texel along a seam. */
const DENSITY = 2;
/** Weight of keeping a texel's value; the weight of equal values on both sides of a seam is 1. */
const KEEP = 0.02;
const MOST_ITERATIONS = 60;
/** Share of the initial squared residual at which the iteration stops. */
const ENOUGH = 1e-8;

/**
 * Least-squares problem of texels along seams: bilinear samples of both sides should be equal, and texels should keep
 * their values. Solved by conjugate gradients.
 *
 * @see Iwanicki 2013, Lighting Technology of The Last of Us; Hestenes and Stiefel 1952
 */
export class SeamSystem {
  /** Index in `texels` of each texel along a seam (an unknown of the system), by texel index; -1 for other texels. */
  private readonly numbers: Int32Array;
  private readonly texels: number[] = [];
  /** Eight entries per sample: indices in `texels`; their weights are in `weights`, negative for the second side. */
  private readonly places: number[] = [];
  private readonly weights: number[] = [];

  /** @param size - side of the lightmap (texels) */
  constructor(private readonly size: number) {
    this.numbers = new Int32Array(size * size).fill(-1);
  }

  /** Adds a seam by its end points (u, v) on the first and on the second side. */
  add(a0: readonly number[], a1: readonly number[], b0: readonly number[], b1: readonly number[]): void {
    const length = (from: readonly number[], to: readonly number[]): number =>
      this.size * Math.hypot(to[0] - from[0], to[1] - from[1]);
    const steps = Math.max(1, Math.ceil(DENSITY * Math.max(length(a0, a1), length(b0, b1))));
    for (let i = 0; i <= steps; i++) {
      const t = i / steps;
      this.sample(a0[0] + t * (a1[0] - a0[0]), a0[1] + t * (a1[1] - a0[1]), 1);
      this.sample(b0[0] + t * (b1[0] - b0[0]), b0[1] + t * (b1[1] - b0[1]), -1);
    }
  }

  /** Changes a lightmap's texels, four floats each, so that sides of seams match. No value becomes negative. */
  solve(data: Float32Array): void {
    if (this.texels.length === 0) return;
    const places = Int32Array.from(this.places);
    const weights = Float32Array.from(this.weights);
    for (let channel = 0; channel < 3; channel++) {
      const values = Float32Array.from(this.texels, (texel) => data[4 * texel + channel]);
      const change = solveChange(places, weights, values);
      this.texels.forEach((texel, i) => (data[4 * texel + channel] = Math.max(0, values[i] + change[i])));
    }
  }

  private sample(u: number, v: number, sign: number): void {
    const { size } = this;
    const [x, y] = [u * size - 0.5, v * size - 0.5];
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const [right, up] = [x - column, y - row];
    for (let k = 0; k < 4; k++) {
      const weight = ((k & 1) === 0 ? 1 - right : right) * (k < 2 ? 1 - up : up);
      const texelX = Math.min(Math.max(column + (k & 1), 0), size - 1);
      const texelY = Math.min(Math.max(row + (k >> 1), 0), size - 1);
      this.places.push(this.numberOf(texelY * size + texelX));
      this.weights.push(sign * weight);
    }
  }

  private numberOf(texel: number): number {
    if (this.numbers[texel] < 0) this.numbers[texel] = this.texels.push(texel) - 1;
    return this.numbers[texel];
  }
}

/** Changes to add to `values` so that samples of both sides are equal. */
function solveChange(places: Int32Array, weights: Float32Array, values: Float32Array): Float32Array {
  const count = values.length;
  const samples = places.length / 8;
  /** Adds AᵀA `from` to `to`, where A gives the differences between the sides of each sample. */
  const addNormal = (from: Float32Array, to: Float32Array): void => {
    for (let i = 0; i < 8 * samples; i += 8) {
      let difference = 0;
      for (let k = i; k < i + 8; k++) difference += weights[k] * from[places[k]];
      for (let k = i; k < i + 8; k++) to[places[k]] += weights[k] * difference;
    }
  };
  const diagonal = new Float32Array(count).fill(KEEP);
  for (let k = 0; k < places.length; k++) diagonal[places[k]] += weights[k] ** 2;
  const change = new Float32Array(count);
  const residual = new Float32Array(count);
  addNormal(values, residual);
  for (let i = 0; i < count; i++) residual[i] = -residual[i];
  const direction = residual.map((value, i) => value / diagonal[i]);
  const applied = new Float32Array(count);
  let energy = residual.reduce((sum, value, i) => sum + value * direction[i], 0);
  const enough = ENOUGH * energy;
  for (let iteration = 0; iteration < MOST_ITERATIONS && energy > enough; iteration++) {
    for (let i = 0; i < count; i++) applied[i] = KEEP * direction[i];
    addNormal(direction, applied);
    let along = 0;
    for (let i = 0; i < count; i++) along += direction[i] * applied[i];
    const step = energy / along;
    let next = 0;
    for (let i = 0; i < count; i++) {
      change[i] += step * direction[i];
      residual[i] -= step * applied[i];
      next += (residual[i] * residual[i]) / diagonal[i];
    }
    for (let i = 0; i < count; i++) direction[i] = residual[i] / diagonal[i] + (next / energy) * direction[i];
    energy = next;
  }
  return change;
}
