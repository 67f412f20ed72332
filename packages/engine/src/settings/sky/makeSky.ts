import type { Vector3Tuple } from '@farol/editing/fields';
import {
  ClampToEdgeWrapping,
  DataTexture,
  EquirectangularReflectionMapping,
  HalfFloatType,
  LinearFilter,
  RepeatWrapping,
  RGBAFormat,
} from 'three';
import type { SkyPreset } from '../pictureFields';
import { dayLook } from './dayLook';
import type { DaySky } from './daySky';
import { paintSky } from './paintSky';
import { type SkyLook, skyLooks } from './skyLooks';

/** A sky as three draws it and lights a scene with it. */
export interface Sky {
  /** Equirectangular image, linear radiance. */
  readonly texture: DataTexture;
  /** Mean radiance at the horizon. */
  readonly horizon: Vector3Tuple;
  /** Irradiance of level ground: the integral of radiance times cosine; only for a day's sky. */
  readonly irradiance?: number;
}

/** Three colours of a sky, from bottom to top. */
export interface SkyGradient {
  readonly top: Vector3Tuple;
  readonly horizon: Vector3Tuple;
  readonly ground: Vector3Tuple;
}

/** Widths (pixels) of sky images: of a preset or a night, with small discs and stars, and of a gradient. */
const PRESET_WIDTH = 1024;
const GRADIENT_WIDTH = 256;
/** Width (pixels) of a day's sky without stars, which is repainted while the sun moves: about 10 ms. */
const DAY_WIDTH = 512;

/** Pixels of a sky, in the form that three uploads. */
interface Painted {
  readonly pixels: Float32Array;
  readonly halves: Uint16Array<ArrayBuffer>;
  readonly width: number;
  readonly horizon: Vector3Tuple;
}

function paint(look: SkyLook, width: number): Painted {
  const height = width / 2;
  const pixels = paintSky(look, width, height);
  const halves = new Uint16Array(width * height * 4);
  const bits = new Uint32Array(pixels.buffer);
  const one = 0x3c00;
  for (let from = 0, to = 0; from < pixels.length; from += 3, to += 4) {
    halves[to] = halfOf(bits[from]);
    halves[to + 1] = halfOf(bits[from + 1]);
    halves[to + 2] = halfOf(bits[from + 2]);
    halves[to + 3] = one;
  }
  return { pixels, halves, width, horizon: horizonOf(pixels, width, height) };
}

function skyOf({ halves, width, horizon }: Painted): Sky {
  const texture = new DataTexture(halves, width, width / 2, RGBAFormat, HalfFloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return { texture, horizon };
}

/** Mean radiance of the first row above the horizon. */
function horizonOf(pixels: Float32Array, width: number, height: number): Vector3Tuple {
  const first = (height / 2) * width * 3;
  const count = width * 3;
  const sum = [0, 0, 0];
  // limited, so that a sun near the horizon does not make the fog glow
  for (let at = first; at < first + count; at++) sum[at % 3] += Math.min(1.5, pixels[at]);
  return [sum[0] / width, sum[1] / width, sum[2] / width];
}

/** Presets that were painted: each takes about 0.1 s and 4 MB. */
const painted = new Map<SkyPreset, Painted>();

/** Sun position (rad): azimuth from +x to +z, elevation above the horizon. */
export interface SunPlace {
  readonly azimuth: number;
  readonly elevation: number;
}

/** The last preset that was painted with a moved sun. */
let moved: { readonly key: string; readonly painted: Painted } | null = null;

function paintMoved(preset: SkyPreset, sun: SunPlace): Painted {
  const key = [preset, sun.azimuth, sun.elevation].join(' ');
  if (moved?.key !== key) {
    const look = skyLooks[preset];
    moved = { key, painted: paint({ ...look, disc: look.disc && { ...look.disc, ...sun } }, PRESET_WIDTH) };
  }
  return moved.painted;
}

/** Makes the sky of a preset. @param sun - direction of its sun; null for the preset's own */
export function makePresetSky(preset: SkyPreset, sun: SunPlace | null = null): Sky {
  if (sun && skyLooks[preset].disc) return skyOf(paintMoved(preset, sun));
  let one = painted.get(preset);
  if (!one) painted.set(preset, (one = paint(skyLooks[preset], PRESET_WIDTH)));
  return skyOf(one);
}

/** Irradiance of level ground by the upper half of a sky: the integral of luminance times cosine. */
function irradianceOf(pixels: Float32Array, width: number): number {
  const height = width / 2;
  const step = Math.PI / height;
  let sum = 0;
  for (let row = height / 2; row < height; row++) {
    const elevation = (row + 0.5) * step - Math.PI / 2;
    let ring = 0;
    for (let at = row * width * 3; at < (row + 1) * width * 3; at += 3)
      ring += 0.2126 * pixels[at] + 0.7152 * pixels[at + 1] + 0.0722 * pixels[at + 2];
    sum += ring * Math.sin(elevation) * Math.cos(elevation);
  }
  return sum * step * step;
}

/** Makes a day's or a night's sky, without clouds. */
export function makeDaySky(day: DaySky): Sky {
  const look = dayLook(day);
  const width = look.stars > 0 ? PRESET_WIDTH : DAY_WIDTH;
  const one = paint(look, width);
  return { ...skyOf(one), irradiance: irradianceOf(one.pixels, width) };
}

/** Makes a sky of three colours. */
export const makeGradientSky = (colours: SkyGradient): Sky =>
  skyOf(paint({ ...colours, disc: null, clouds: null, stars: 0, boxes: [] }, GRADIENT_WIDTH));

/**
 * Converts a non-negative 32-bit float to a half float, rounded towards 0, as three's `DataUtils.toHalfFloat` at a
 * fraction of the cost: an image has 1.5 million values.
 * @param bits - bits of the float; too large values and NaN give the largest half float, 65504
 */
export function halfOf(bits: number): number {
  const exponent = bits >>> 23;
  if (exponent >= 113) return Math.min((bits >>> 13) - (112 << 10), 0x7bff);
  return exponent < 103 ? 0 : ((bits & 0x7fffff) | 0x800000) >> (126 - exponent);
}
