import type { View } from './frame/views';
import type { FarolEffect } from './frame/FarolEffect';
import type { TechniqueName } from './techniques';

export interface FarolOptions {
  /** Key of `techniques`. Default 'auto'. */
  technique?: TechniqueName;
  /** Default 'final'. */
  view?: View;
  /** Times each pass on the GPU where the device can. Default false: a host may time with a query of its own. */
  timing?: boolean;
  /** Default none. */
  effects?: readonly FarolEffect[];
  /**
   * Texels a side of the texture that holds all shadow maps, at most; it is made as large as the lights ask for. At least
   * 512, at most what the device has. Default: by the picture, 6656 up to 1280 × 720 pixels, 8192 from 1600 × 900 on; more
   * for lights without a range, but no more than 8192.
   */
  shadowAtlasSize?: number;
  /** As the property of that name. Default true. */
  antialias?: boolean;
  /** As the property of that name. Default false. */
  lightLayers?: boolean;
}
