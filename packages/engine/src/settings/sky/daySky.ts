/** A direction in the sky (rad): azimuth from +x to +z, elevation above the horizon. */
export interface SkyDirection {
  readonly azimuth: number;
  readonly elevation: number;
}

/** Sun and moon of a sky without clouds. */
export interface DaySky {
  readonly sun: SkyDirection;
  readonly moon: SkyDirection;
  /** Part of the moon's disc that is lit. */
  readonly lit: number;
  /** Illuminance of level ground by the sky (lx), without sun and moon; null leaves the brightness that suits a screen. */
  readonly illuminance: number | null;
}

/** Elevation of the sun (rad) below which its glow is gone, and the moon takes its place in the sky. */
export const NIGHT = (-8 * Math.PI) / 180;

/** Elevation (rad) from which the moon is seen. */
export const MOONRISE = -0.02;
