import { unknownName } from './errors';
import type { FrameBudget } from './FrameBudget';
import type { View } from '../frame/views';
import type { Quality } from '../gpu/isWeakDevice';
import type { FarolEffect } from '../frame/FarolEffect';
import type { TechniqueName } from '../techniques';

/** Options of a FarolRenderer. Each is also a property of the renderer; changes apply from the next frame on. */
export interface FarolOptions {
  /** Name of the technique, a key of `FarolRenderer.techniques`. Default 'auto'. */
  technique?: TechniqueName;
  /** The finished picture ('final'), or a view of how it is made. Default 'final'. */
  view?: View;
  /**
   * 'lite': G-buffers of 14 bytes a pixel and depth in place of 20, where materials that need more are drawn forward, and
   * shadow maps within 10 bytes a pixel of the picture. 'auto': 'lite' on a device that draws to no colour buffers of 32-bit
   * floats or to at most 7 colour buffers at once, has no textures of 8,192 texels a side, no `highp` in fragment shaders, or
   * at most 2 GB of memory, and on one whose only pointers are coarse (phones, tablets, headsets); else 'full'. Default 'auto'.
   */
  quality?: Quality;
  /**
   * Holds a frame's time by drawing the scene at a smaller scale and enlarging the picture to the target's size:
   * `{ frame: 16.7, min: 0.5, max: 1 }` has milliseconds a frame, and limits of the scale along a side. `FarolInfo.budget` tells
   * the present scale. Frames are timed by the GPU, else by the intervals between them, which tell a frame's time only if the
   * host draws continuously. Default null: the scene is drawn at the size of its target.
   */
  budget?: FrameBudget | null;
  /**
   * Whether 'auto' learns which technique is faster on this GPU: where its rules are close to choosing another, that one draws
   * up to 2% of the frames and is timed. `localStorage` keeps what was learnt; `clearLearnt()` forgets it. Nothing is learnt
   * without EXT_disjoint_timer_query_webgl2, in XR sessions, or while there is a `budget`. Default false.
   */
  learning?: boolean;
  /** Whether each pass is timed by EXT_disjoint_timer_query_webgl2. Default false: then a host's own time queries work. */
  timing?: boolean;
  /**
   * Effects that are drawn besides the technique, in this order: anti-aliasing, ambient occlusion, decals and the
   * like, each from its own entry of the package. The FarolRenderer disposes those in the list with itself; the host disposes
   * others. Default none.
   */
  effects?: readonly FarolEffect[];
  /**
   * Largest side (texels) of the texture that holds all shadow maps, which is only as large as the lights need. At least 512, at
   * most the device's limit. A change draws all maps anew. Default null: by the picture, 6656 up to 1280 × 720 pixels, 8192 from
   * 1600 × 900 on; more for lights without a range, but no more than 8192.
   */
  shadowAtlasSize?: number | null;
  /**
   * Number of shadow maps of each directional light, 1 to 4: the last covers the light's shadow camera, each earlier one only
   * what is near the viewer, a quarter as far as the next, at the same size. Not for VSMShadowMap. Default 1, as in three.
   */
  shadowCascades?: number;
  /**
   * Whether a directional, point or spot light reaches only objects that share a layer with it (`light.layers`,
   * `object.layers`); as in three, it gives light only if the camera shares a layer with it. Objects with other
   * layers than most are then drawn forward, by every technique. Default false, as in three: all lights reach all
   * objects.
   */
  lightLayers?: boolean;
  /**
   * Whether SMAA smooths edges for techniques that shade a G-buffer, and therefore only one sample a pixel, where the canvas
   * (`antialias` of the WebGLRenderer) or the render target (`samples`) is multisampled and none of `effects` smooths edges.
   * Other techniques are multisampled there as stock three is. Default true.
   */
  antialias?: boolean;
  /**
   * A RectAreaLight without `userData.farol.range` ends at the distance where the irradiance of a surface that faces it falls
   * to this (unit of `intensity` × steradian). Up to half of that distance it is as bright as in three. 0: no light ends.
   * Default 0.0002.
   */
  areaLightThreshold?: number;
  /** Side of the lighting buffers of the technique 'inferred', as a share of the picture's: above 0, at most 1. Default 0.5. */
  inferredScale?: number;
  /** Count of lights (or draws) at a pixel that heat-map views show in their hottest colour. Above 0. Default 32. */
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
 * Sets all options of a FarolRenderer; undefined ones get their default.
 * @throws Error for an unknown option, naming the nearest known one, or for a value that an option cannot have
 */
export function setOptions(farol: Required<FarolOptions>, options: FarolOptions): void {
  const values = options as Record<string, unknown>;
  for (const name in values)
    if (!(name in defaultOptions)) throw unknownName('option', name, Object.keys(defaultOptions));
  for (const [name, value] of Object.entries(defaultOptions)) Object.assign(farol, { [name]: values[name] ?? value });
}

/** Events of a FarolRenderer. */
export interface FarolEvents {
  /** Code that the last picture lacked is loaded, so the picture is out of date: draw again. */
  redraw: object;
}
