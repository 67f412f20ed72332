import type { ColorRepresentation, Light, Object3D, Texture } from 'three';
import type { BakeProgress } from './BakeProgress';

/**
 * Light from beyond the scene: none, the scene's environment, one colour (linear radiance, W/sr/m²), or an
 * equirectangular texture. Ambient and hemisphere lights that are baked are added to it, as three reckons them.
 */
export type Sky = 'none' | 'environment' | ColorRepresentation | Texture;

/** Options that lightmaps and light probes share. */
export interface TraceOptions {
  /** Times that light is reflected before it arrives, 0 (direct light only) to 16. Default 3. */
  bounces?: number;
  /**
   * Paths of indirect light that arrive at each texel, 1 to 65,536: so many of light that comes from the sky or was
   * reflected once, half as many of light that was reflected once more, and so on, 16 at least; probes take 1,024 at least.
   * Default 256.
   */
  samples?: number;
  /**
   * Resolution at which light that was reflected twice or more is gathered, as a share of the lightmap's side: 1, 0.5
   * or 0.25. Texels between are interpolated from their neighbours on the same surface. Default 0.5.
   */
  indirectScale?: 1 | 0.5 | 0.25;
  /** Light from beyond the scene. Default 'none'. */
  sky?: Sky;
  /** Equal seeds give equal bakes on one machine: a whole number. Default 1. */
  seed?: number;
  /** Milliseconds of GPU time between two moments at which the page may draw, 1 to 1,000. Default 12. */
  sliceMilliseconds?: number;
  /**
   * Whether a mesh stays where it is: it casts shadows and reflects light, and gets a lightmap. Default: each that is visible.
   * @param instance - of an InstancedMesh that is static: whether this one of its instances is
   */
  isStatic?(object: Object3D, instance?: number): boolean;
  /**
   * Whether a light is baked: its direct and its reflected light, or 'indirect', its reflected light alone, while the
   * renderer goes on with the direct one. Default: each that is visible.
   */
  isBaked?(light: Light): boolean | 'indirect';
  /** Whether a static mesh blocks light: the shade of a lamp, for example, may let it through. Default: each does. */
  throwsShadow?(object: Object3D): boolean;
  /** Cancels: the scene is left as it was, and the promise rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Called after each slice of work. */
  onProgress?(progress: BakeProgress): void;
  /**
   * Called once for each thing that was left out or baked otherwise than asked, with a sentence that names it. Default:
   * console.warn.
   */
  onWarning?(sentence: string): void;
}

/** Options of `bakeLightmaps`. */
export interface BakeOptions extends TraceOptions {
  /** Width and height of a lightmap in texels: a multiple of 16, 16 to 8,192. Default 1,024. */
  size?: number;
  /** Texels along a metre of surface. Default: as many as one lightmap has room for; given, there are as many lightmaps as it takes. */
  texelsPerMetre?: number;
  /** Texels between the charts of a lightmap, 1 to 16: dilated, so that mipmaps and bilinear filtering stay in a chart. Default 4. */
  padding?: number;
  /** Takes out the noise that is left, keeping edges of light at edges of surfaces. Default true. */
  denoise?: boolean;
  /** Makes light meet where charts cut a smooth surface: else the borders of charts show as lines. Default true. */
  stitch?: boolean;
  /** Points at which the light that arrives is baked as well, three floats each, world space (m). Default none. */
  probes?: Float32Array;
  /** Whether the picture so far is applied to the scene while the bake runs. Default true. */
  showProgress?: boolean;
}
