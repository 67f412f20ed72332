import type { ColorRepresentation, Light, Object3D, Texture } from 'three';
import type { BakeProgress } from './BakeProgress';

/**
 * Light from beyond the scene: none, the scene's environment, one colour (linear radiance, W/sr/m²), or an
 * equirectangular texture. Baked ambient and hemisphere lights are added, as in three.
 */
export type Sky = 'none' | 'environment' | ColorRepresentation | Texture;

/** Options that lightmaps and light probes share. */
export interface TraceOptions {
  /** Number of reflections of light, 0 (direct light only) to 16. Default 3. */
  bounces?: number;
  /**
   * Paths of indirect light per texel, 1 to 65,536: this many for light from the sky or reflected once, half as many
   * for each further reflection, at least 16; probes use at least 1,024. Default 256.
   */
  samples?: number;
  /**
   * Resolution of light that was reflected twice or more, as a share of the lightmap's side: 1, 0.5 or 0.25. It is
   * interpolated between neighbours on the same surface. Default 0.5.
   */
  indirectScale?: 1 | 0.5 | 0.25;
  /** Light from outside the scene. Default 'none'. */
  sky?: Sky;
  /** Integer seed; equal seeds give equal bakes on one machine. Default 1. */
  seed?: number;
  /** GPU time (ms) after which the page may draw a frame, 1 to 1,000. Default 12. */
  sliceMilliseconds?: number;
  /**
   * Whether a mesh never moves: it then casts shadows, reflects light and gets a lightmap. Default: every visible mesh.
   * @param instance - index of an instance, when asked about each instance of a static InstancedMesh; else absent
   */
  isStatic?(object: Object3D, instance?: number): boolean;
  /**
   * Whether a light is baked: true for direct and reflected light; 'indirect' for reflected light only, while the
   * renderer draws the direct light. Default: every visible light.
   */
  isBaked?(light: Light): boolean | 'indirect';
  /** Whether a static mesh blocks light; a lamp shade, for instance, may transmit it. Default: every mesh does. */
  throwsShadow?(object: Object3D): boolean;
  /** Cancels the bake: the scene is restored, and the promise rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Called after each slice of work. */
  onProgress?(progress: BakeProgress): void;
  /**
   * Called with a sentence for each object that was left out or baked differently than requested. Default:
   * console.warn.
   */
  onWarning?(sentence: string): void;
}

/** Options of `bakeLightmaps`. */
export interface BakeOptions extends TraceOptions {
  /** Width and height of a lightmap in texels: a multiple of 16, 16 to 8,192. Default 1,024. */
  size?: number;
  /** Texels per metre of surface; as many lightmaps as needed are made. Default: the most that fit into one. */
  texelsPerMetre?: number;
  /** Texels between charts, 1 to 16, filled so that mipmaps and bilinear filtering do not mix charts. Default 4. */
  padding?: number;
  /** Whether to remove noise, while edges of light at edges of surfaces are kept. Default true. */
  denoise?: boolean;
  /** Whether to equalise light at chart borders on smooth surfaces, where it else shows as lines. Default true. */
  stitch?: boolean;
  /** Positions of light probes to bake as well, three floats each, world space (m). Default none. */
  probes?: Float32Array;
  /** Whether intermediate results are applied to the scene during the bake. Default true. */
  showProgress?: boolean;
}
