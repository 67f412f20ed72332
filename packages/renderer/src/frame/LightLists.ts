import type { LightLoop } from '../materials/LightLoop';

/** How a shader finds the lights of its pixel; the lists themselves are in the shared uniforms. */
export interface LightLists {
  readonly loop: LightLoop;
  /** Defines of a program that walks them over a G-buffer. */
  readonly defines: Readonly<Record<string, string>>;
}
