/** A direction in the sky (rad): azimuth from +x to +z, elevation above the horizon. */
export interface SkyDirection {
  readonly azimuth: number;
  readonly elevation: number;
}

/** Sun and moon in a cloudless sky. */
export interface DaySky {
  readonly sun: SkyDirection;
  readonly moon: SkyDirection;
  /** Lit part of the moon's disc, 0 to 1. */
  readonly lit: number;
  /** Illuminance of level ground by the sky (lx), without sun and moon; null for a brightness that suits a screen. */
  readonly illuminance: number | null;
}

/** Elevation of the sun (rad) below which its glow has faded, and the moon is drawn instead. */
export const NIGHT = (-8 * Math.PI) / 180;

/** Elevation (rad) above which the moon is visible. */
export const MOONRISE = -0.02;
