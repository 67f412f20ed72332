import type { Light } from 'three';
import { type PlainPoints, POINT } from './plainPoints';

/** A light, or an object above one. */
export type Placed = NonNullable<Light['parent']>;

/** Numbers of one light in `FoundLights.poses`. */
export const POSE = 8;

/** Lights of a frame, in arrays that keep their length so that they need not grow again. */
export class FoundLights {
  /** All managed lights of the frame, the first `count`; the rest is left from the frame before. */
  readonly all: Light[] = [];
  /** Number of lights of this frame in `all`. */
  count = 0;
  /** Place, colour and range of each light in `all`, see `readPoint`; longer where earlier frames had more. */
  points: PlainPoints = new Float64Array(0);
  /**
   * Quaternion and scale of each light in `all` when its matrix was last composed, and element 10 of that matrix; the first
   * is NaN where they are not known.
   */
  poses = new Float64Array(0);
  /** Index of the first child of the scene that is not read ahead yet. */
  fetched = 0;
  /** Managed lights that three's traversal would meet: those in `rest`, and below. */
  readonly nested: Light[] = [];
  /** Children of a Scene as root, without those that only hold managed lights; for another root, that root. */
  readonly rest: Placed[] = [];
  /** Whether `masks` counts the lights that cast a shadow, throw an image or have a profile. */
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
    if (points.length < (count + more) * POINT) {
      this.points = new Float64Array((count + more) * 2 * POINT);
      this.points.set(points);
      this.poses = new Float64Array((count + more) * 2 * POSE).fill(NaN);
      this.poses.set(poses);
    }
    return count;
  }

  /** Adds a light whose matrix was composed elsewhere. */
  add(light: Light): void {
    this.poses[this.count * POSE] = NaN;
    this.all[this.count++] = light;
  }
}
