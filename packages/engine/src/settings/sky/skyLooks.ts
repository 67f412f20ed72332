import type { Vector3Tuple } from '@farol/editing/fields';
import type { SkyPreset } from '../pictureFields';

export interface SkyDisc {
  /** Elevation above the horizon (rad). */
  readonly elevation: number;
  /** Azimuth from +x to +z (rad). */
  readonly azimuth: number;
  /** Angular radius, from the middle to the edge (rad). */
  readonly radius: number;
  /** Radiance, linear RGB. */
  readonly colour: Vector3Tuple;
  /** Radiance of the glow close to the disc, and of the wide glow. */
  readonly glow: Vector3Tuple;
  readonly haze: Vector3Tuple;
}

/** Clouds on a horizontal plane. */
export interface SkyClouds {
  /** Cloud cover, 0 to 1 (approximate). */
  readonly cover: number;
  readonly light: Vector3Tuple;
  readonly dark: Vector3Tuple;
}

/** A lit rectangle on the walls of a studio: direction of its middle, its half sizes (radians) and radiance. */
export interface SkyBox {
  readonly elevation: number;
  readonly azimuth: number;
  readonly halfWidth: number;
  readonly halfHeight: number;
  readonly radiance: number;
}

/** Colours of a sky: linear radiance, where 1 is a white surface in full light. */
export interface SkyLook {
  readonly top: Vector3Tuple;
  readonly horizon: Vector3Tuple;
  readonly ground: Vector3Tuple;
  readonly disc: SkyDisc | null;
  readonly clouds: SkyClouds | null;
  /** Number of stars on the whole sphere. */
  readonly stars: number;
  readonly boxes: readonly SkyBox[];
}

const degrees = Math.PI / 180;
/** Azimuth ahead and to the left of a camera that faces -z. */
const AHEAD = -115 * degrees;

export const skyLooks: Readonly<Record<SkyPreset, SkyLook>> = {
  'clear-day': {
    top: [0.07, 0.19, 0.5],
    horizon: [0.58, 0.72, 0.86],
    ground: [0.2, 0.18, 0.15],
    disc: {
      elevation: 38 * degrees,
      azimuth: AHEAD,
      radius: 0.9 * degrees,
      colour: [48, 45, 38],
      glow: [1.2, 1.1, 0.9],
      haze: [0.22, 0.2, 0.16],
    },
    clouds: { cover: 0.42, light: [1.25, 1.23, 1.2], dark: [0.55, 0.6, 0.7] },
    stars: 0,
    boxes: [],
  },
  overcast: {
    top: [0.5, 0.53, 0.58],
    horizon: [0.66, 0.69, 0.73],
    ground: [0.16, 0.16, 0.15],
    disc: null,
    clouds: { cover: 0.85, light: [0.78, 0.8, 0.83], dark: [0.36, 0.39, 0.44] },
    stars: 0,
    boxes: [],
  },
  sunset: {
    top: [0.07, 0.1, 0.24],
    horizon: [0.5, 0.3, 0.24],
    ground: [0.06, 0.05, 0.05],
    disc: {
      elevation: 4 * degrees,
      azimuth: AHEAD,
      radius: 1.1 * degrees,
      colour: [36, 15, 4.5],
      glow: [2.4, 0.95, 0.25],
      haze: [1.1, 0.42, 0.1],
    },
    clouds: { cover: 0.38, light: [1.3, 0.55, 0.3], dark: [0.16, 0.13, 0.2] },
    stars: 0,
    boxes: [],
  },
  night: {
    top: [0.003, 0.005, 0.014],
    horizon: [0.018, 0.026, 0.05],
    ground: [0.004, 0.004, 0.006],
    disc: {
      elevation: 30 * degrees,
      azimuth: AHEAD,
      radius: 1.2 * degrees,
      colour: [2.6, 2.7, 2.9],
      glow: [0.05, 0.055, 0.07],
      haze: [0.012, 0.014, 0.02],
    },
    clouds: null,
    stars: 2600,
    boxes: [],
  },
  studio: {
    top: [0.09, 0.09, 0.095],
    horizon: [0.3, 0.3, 0.3],
    ground: [0.13, 0.13, 0.13],
    disc: null,
    clouds: null,
    stars: 0,
    boxes: [
      { elevation: 72 * degrees, azimuth: -90 * degrees, halfWidth: 0.6, halfHeight: 0.28, radiance: 3.2 },
      { elevation: 22 * degrees, azimuth: -148 * degrees, halfWidth: 0.3, halfHeight: 0.42, radiance: 3.5 },
      { elevation: 18 * degrees, azimuth: 20 * degrees, halfWidth: 0.14, halfHeight: 0.45, radiance: 4 },
      { elevation: 30 * degrees, azimuth: 110 * degrees, halfWidth: 0.5, halfHeight: 0.2, radiance: 1.4 },
    ],
  },
};
