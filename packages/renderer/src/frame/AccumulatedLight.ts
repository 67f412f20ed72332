import type { Texture } from 'three';

/** Result of multipass lighting: the sum of all lights on each surface. */
export interface AccumulatedLight {
  /** Sum of the lights' linear radiance; alpha 1 where a surface was drawn. */
  readonly texture: Texture;
  readonly depth: Texture;
  /** Whether the sums contain fog; else the output pass adds it, since three draws fog after encoding. */
  readonly hasFog: boolean;
}
