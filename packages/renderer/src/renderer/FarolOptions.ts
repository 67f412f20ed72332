import { unknownName } from './errors';
import type { FrameBudget } from './FrameBudget';
import type { View } from '../frame/views';
import type { Quality } from '../gpu/isWeakDevice';
import type { FarolEffect } from '../frame/FarolEffect';
import type { TechniqueName } from '../techniques';

/** Options of a FarolRenderer. Each is also a property of the renderer; changes apply from the next frame on. */
export interface FarolOptions {
  /** Key of `techniques`. Default 'auto'. */
  technique?: TechniqueName;
  /** The finished picture ('final'), or a view of how it is made. Default 'final'. */
  view?: View;
  /**
   * 'lite': G-buffers of 14 bytes a pixel and depth in place of 20, with materials that these do not hold drawn forward, and
   * shadow maps within 10 bytes a pixel of the picture. 'auto': 'lite' on a device that draws to no colour buffers of
   * whole floats or to fewer than 8 colour buffers at once, has no textures of 8,192 texels a side, no `highp` in fragment shaders, or at most
   * 2 GB of memory, and on one that is touched and has no finer pointer (phones, tablets, headsets); else 'full'. Default
   * 'auto'.
   */
  quality?: Quality;
  /**
   * Holds the time of a frame by the scale that the scene is drawn at, enlarged to the target's size:
   * `{ frame: 16.7, min: 0.5, max: 1 }` in milliseconds a frame and pixels a pixel, along a side. `FarolInfo.budget` says what it
   * does. Times are the GPU's, else those from frame to frame, which mean something only where frames are drawn one after the
   * other. Default null: the scene is drawn at the size of its target.
   */
  budget?: FrameBudget | null;
  /**
   * Whether 'auto' learns which technique is faster on this GPU: where it hesitates between two, at most 2% of the draws are by the
   * other one, and timed. `localStorage` keeps what was learnt; `clearLearnt()` forgets it. Nothing is learnt without
   * EXT_disjoint_timer_query_webgl2, in XR sessions, or while there is a `budget`. Default false.
   */
  learning?: boolean;
  /** Times each pass on the GPU, by EXT_disjoint_timer_query_webgl2. Default false: a host may time with a query of its own. */
  timing?: boolean;
  /**
   * Effects that take part in the frame beside the technique, in this order: anti-aliasing, ambient occlusion, decals and the
   * like, from entries of the package of their own. Effects that are left out stay the host's to dispose, those in the list are
   * disposed with the FarolRenderer. Default none.
   */
  effects?: readonly FarolEffect[];
  /**
   * Texels a side of the texture that holds all shadow maps, at most; it is made as large as the lights ask for. At least
   * 512, at most what the device has. A change draws all maps anew. Default null: by the picture, 6656 up to 1280 × 720 pixels,
   * 8192 from 1600 × 900 on; more for lights without a range, but no more than 8192.
   */
  shadowAtlasSize?: number | null;
  /**
   * Shadow maps of each directional light, 1 to 4: the last is the light's own, those before it see what is near the camera,
   * each a quarter as far as the next, in maps of the same size. Not for VSMShadowMap. Default 1, as in three.
   */
  shadowCascades?: number;
  /**
   * Whether a directional, point or spot light reaches only objects that share a layer with it (`light.layers`,
   * `object.layers`); a light is lit at all if the camera shares a layer with it, as in three. Objects with other
   * layers than most are then drawn forward, by every technique. Default false, as in three: all lights reach all
   * objects.
   */
  lightLayers?: boolean;
  /**
   * Whether techniques that shade a G-buffer, and so one sample a pixel, smooth edges by SMAA where the canvas (`antialias` of
   * the WebGLRenderer) or the render target (`samples`) asks for more, unless one of `effects` does it. The others are
   * multisampled there as stock three is. Default true.
   */
  antialias?: boolean;
  /**
   * Irradiance at which a RectAreaLight without `userData.farol.range` ends, in a surface that faces it: where it ends, lists
   * leave it out. Up to half of that distance it gives what three has it give. Above 0; 0: no such light ends. Default 0.0002.
   */
  areaLightThreshold?: number;
  /**
   * Texels of the lighting buffers of the technique 'inferred' a pixel of the picture, along a side: above 0, at most 1.
   * Default 0.5.
   */
  inferredScale?: number;
  /** Lights a pixel (or draws a pixel) that the count views show hottest. Above 0. Default 32. */
  heatMapMaximum?: number;
}

/** Default of every option, by name. */
export const defaultOptions: Required<FarolOptions> = {
  technique: 'auto',
  view: 'final',
  quality: 'auto',
  budget: null,
  learning: false,
  timing: false,
  effects: [],
  shadowAtlasSize: null,
  shadowCascades: 1,
  lightLayers: false,
  antialias: true,
  areaLightThreshold: 2e-4,
  inferredScale: 0.5,
  heatMapMaximum: 32,
};

/**
 * Sets all options of a FarolRenderer: those that are undefined to their default.
 * @throws Error for one that does not exist, with the name that is nearest, or a value that an option cannot have
 */
export function setOptions(farol: Required<FarolOptions>, options: FarolOptions): void {
  const values = options as Record<string, unknown>;
  for (const name in values)
    if (!(name in defaultOptions)) throw unknownName('option', name, Object.keys(defaultOptions));
  for (const [name, value] of Object.entries(defaultOptions)) Object.assign(farol, { [name]: values[name] ?? value });
}

/** Events of a FarolRenderer. */
export interface FarolEvents {
  /** The last picture is out of date, since code that it lacked has come: draw again. */
  redraw: object;
}
