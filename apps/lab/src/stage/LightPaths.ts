import { createRandom } from '@farol/engine';
import type { Vector3 } from 'three';

export interface LightPath {
  /** World position at time 0 (m). */
  readonly place: readonly [number, number, number];
  /** Greatest distance from the place along each axis (m). */
  readonly extent: readonly [number, number, number];
  /** Greatest speed along an axis (m/s). */
  readonly speed: number;
  readonly seed: number;
}

/** Numbers per axis of a light's path: centre (m), then amplitude (m) and rate (table steps / s) of two waves. */
const STRIDE = 5;
/** Steps of the sine table per period; a power of two. Interpolated values are accurate to 3e-7. */
const STEPS = 4096;
/** A table, since `Math.sin` takes ten times as long, and 20,000 lights need 120,000 sines per frame. */
const sines = Float64Array.from({ length: STEPS + 1 }, (_, i) => Math.sin((i / STEPS) * 2 * Math.PI));
/** Shares of the two waves in the extent; their sum is 1, so that a light stays within it. */
const SHARES = [0.65, 0.35];

/** Places of lights at any time, in closed form: the sum of two sines along each axis. */
export class LightPaths {
  /** Paths, of shape [lights, 3 axes, STRIDE]. */
  private readonly numbers: Float64Array;

  constructor(paths: readonly LightPath[]) {
    this.numbers = new Float64Array(paths.length * 3 * STRIDE);
    paths.forEach(({ place, extent, speed, seed }, i) => {
      const random = createRandom(seed);
      for (let axis = 0; axis < 3; axis++) {
        const rate = (): number =>
          ((((random() < 0.5 ? -1 : 1) * (0.45 + 0.55 * random()) * speed) / Math.max(extent[axis], 1e-6)) * STEPS) /
          (2 * Math.PI);
        const values = [place[axis], extent[axis] * SHARES[0], rate(), extent[axis] * SHARES[1], rate()];
        this.numbers.set(values, (i * 3 + axis) * STRIDE);
      }
    });
  }

  /** Writes the world position of light `index` at a time (s). */
  place(index: number, seconds: number, position: Vector3): void {
    const at = index * 3 * STRIDE;
    position.set(this.along(at, seconds), this.along(at + STRIDE, seconds), this.along(at + 2 * STRIDE, seconds));
  }

  private along(at: number, seconds: number): number {
    const { numbers } = this;
    return (
      numbers[at] +
      numbers[at + 1] * sine(numbers[at + 2] * seconds) +
      numbers[at + 3] * sine(numbers[at + 4] * seconds)
    );
  }
}

/** Sine by table. @param steps - angle in steps of the table */
function sine(steps: number): number {
  const whole = Math.floor(steps);
  const i = whole & (STEPS - 1);
  return sines[i] + (steps - whole) * (sines[i + 1] - sines[i]);
}
