import type { Light } from 'three';

/** What the maths of lights know of a LightField. */
export interface LightFieldData extends Light {
  readonly capacity: number;
  readonly count: number;
}

/** Lights of a field that are drawn. */
export function fieldCount({ capacity, count }: LightFieldData): number {
  return Math.max(0, Math.min(capacity, Math.floor(count) || 0));
}
