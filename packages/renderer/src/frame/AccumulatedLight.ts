import type { Texture } from 'three';

/** Sums of multipass lighting. */
export interface AccumulatedLight {
  /** Linear radiance; alpha 1 where something was drawn. */
  readonly texture: Texture;
  readonly depth: Texture;
  /** Fog is in the sums; else, where three draws fog after encoding, it is left to the output. */
  readonly hasFog: boolean;
}
