import type { Light } from 'three';
import { type PlainPoints, POINT } from './plainPoints';

/** Light, or ancestor of one. */
export type Placed = NonNullable<Light['parent']>;

/** Lights of a frame, in arrays that keep their length so that they need not grow again. */
export class FoundLights {
  /** Lights of the frame that Farol draws (managed lights): the first `count`; later ones are of an earlier frame. */
  readonly all: Light[] = [];
  /** Number of lights of this frame in `all`. */
  count = 0;
  /** Position, colour and range of each light in `all`, see `readPoint`; longer if earlier frames had more lights. */
  points: PlainPoints = new Float64Array(0);
  /**
   * Quaternion and scale of each light in `all` when its matrix was last composed, and element 10 of that matrix, POINT numbers
   * each; the first is NaN where unknown.
   */
  poses = new Float64Array(0);
  /** Index of the first child of the scene whose data `LightReader` has not yet read ahead into the CPU's caches. */
  fetched = 0;
  /** Managed lights that three's traversal would find: those in `rest`, and descendants of the objects in it. */
  readonly nested: Light[] = [];
  /** Children of a Scene as root, without those that only hold managed lights; for another root, that root. */
  readonly rest: Placed[] = [];
  /** Whether to count, in `masks`, the lights that cast a shadow, project an image or have a profile. */
  seeksMasks = true;
  masks = 0;
  /** Number of lights left to three. */
  left = 0;
  /** Whether a light left to three is an area light. */
  hasArea = false;

  /** Begins a frame. */
  begin(): void {
    this.count = this.fetched = this.masks = this.left = 0;
    this.hasArea = false;
    this.nested.length = this.rest.length = 0;
  }

  /** Makes room for more lights. @returns `count` */
  reserve(more: number): number {
    const { count, points, poses } = this;
    const length = (count + more) * POINT;
    if (points.length < length) {
      (this.points = new Float64Array(length * 2)).set(points);
      (this.poses = new Float64Array(length * 2)).set(poses);
    }
    return count;
  }

  /** Adds a light whose matrix was composed elsewhere. */
  add(light: Light): void {
    this.poses[this.count * POINT] = NaN;
    this.all[this.count++] = light;
  }
}
