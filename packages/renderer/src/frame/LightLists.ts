import type { LightLoop } from '../materials/LightLoop';

/** Shader code that finds the lights of a pixel; the lists themselves are in the shared uniforms. */
export interface LightLists {
  readonly loop: LightLoop;
  /** Defines of a program that loops over the lists for a G-buffer. */
  readonly defines: Readonly<Record<string, string>>;
}
