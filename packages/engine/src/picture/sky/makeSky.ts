import {
  ClampToEdgeWrapping,
  DataTexture,
  DataUtils,
  EquirectangularReflectionMapping,
  HalfFloatType,
  LinearFilter,
  RepeatWrapping,
  RGBAFormat,
} from 'three';
import type { Vector3Tuple } from '../../fields/Field';
import type { SkyPreset } from '../pictureFields';
import { paintSky } from './paintSky';
import { type SkyLook, skyLooks } from './skyLooks';

/** A sky as three draws it, and lights by. */
export interface Sky {
  /** Equirectangular, linear radiance. */
  readonly texture: DataTexture;
  /** Mean radiance at the horizon. */
  readonly horizon: Vector3Tuple;
}

/** Three colours from below to above. */
export interface SkyGradient {
  readonly top: Vector3Tuple;
  readonly horizon: Vector3Tuple;
  readonly ground: Vector3Tuple;
}

/** Columns of the picture of a preset, whose discs and stars are small, and of a gradient. */
const PRESET_WIDTH = 1024;
const GRADIENT_WIDTH = 256;

function pictureOf(look: SkyLook, width: number): Sky {
  const height = width / 2;
  const pixels = paintSky(look, width, height);
  const halves = new Uint16Array(width * height * 4);
  const one = DataUtils.toHalfFloat(1);
  for (let from = 0, to = 0; from < pixels.length; from += 3, to += 4) {
    halves[to] = DataUtils.toHalfFloat(pixels[from]);
    halves[to + 1] = DataUtils.toHalfFloat(pixels[from + 1]);
    halves[to + 2] = DataUtils.toHalfFloat(pixels[from + 2]);
    halves[to + 3] = one;
  }
  const texture = new DataTexture(halves, width, height, RGBAFormat, HalfFloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return { texture, horizon: horizonOf(pixels, width, height) };
}

/** Mean of the first rows above the horizon. */
function horizonOf(pixels: Float32Array, width: number, height: number): Vector3Tuple {
  const first = (height / 2) * width * 3;
  const count = width * 3;
  const sum = [0, 0, 0];
  // what shines is left out: fog does not
  for (let at = first; at < first + count; at++) sum[at % 3] += Math.min(1.5, pixels[at]);
  return [sum[0] / width, sum[1] / width, sum[2] / width];
}

/** Makes one of the skies. */
export const makePresetSky = (preset: SkyPreset): Sky => pictureOf(skyLooks[preset], PRESET_WIDTH);

/** Makes a sky of three colours. */
export const makeGradientSky = (colours: SkyGradient): Sky =>
  pictureOf({ ...colours, disc: null, clouds: null, stars: 0, boxes: [] }, GRADIENT_WIDTH);
