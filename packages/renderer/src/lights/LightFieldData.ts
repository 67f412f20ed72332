import type { Light } from 'three';

/** Parts of a LightField that the maths of lights use. */
export interface LightFieldData extends Light {
  readonly capacity: number;
  readonly count: number;
}

/** Number of lights of a field that are drawn. */
export function fieldCount({ capacity, count }: LightFieldData): number {
  return Math.max(0, Math.min(capacity, Math.floor(count) || 0));
}
