import type { Matrix4, RectAreaLight } from 'three';

/** Writes texels of the light table. */
interface TexelTable {
  set4(at: number, x: number, y: number, z: number, w: number): void;
}

/** Part of the light table for area lights, in late code that is fetched when a scene has one. */
export interface AreaLights {
  /** Irradiance at which a light without `userData.farol.range` ends; 0: none ends. */
  threshold: number;
  /** Radius (m) of a sphere round a light's centre that holds all it lights; 0 without an end, NaN if it gives nothing. */
  radiusOf(light: RectAreaLight): number;
  /** Writes the extension record of a light. @param at - offset of the record in the table (floats) */
  write(table: TexelTable, at: number, light: RectAreaLight, view: Matrix4): void;
  dispose(): void;
}
