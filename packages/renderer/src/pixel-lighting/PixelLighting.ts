import type { Color, Light, Material, Object3D, Vector3 } from 'three';
import type { TechniqueName } from '../techniques';

/** Light that one light gives to a pixel. */
export interface LightShare {
  /** The light, or the LightField that it belongs to. */
  readonly light: Light;
  /**
   * Index of the light in its LightField; null for a light that is an object, and for all lights together of a field that
   * the GPU writes (`LightField.textures`).
   */
  readonly index: number | null;
  /** Light that reaches the pixel: linear RGB, before exposure, tone mapping and encoding. */
  readonly color: Color;
  /** Light that would reach the pixel if the light cast no shadows: linear RGB. */
  readonly unshadowed: Color;
  /** Share of the luminance of `PixelLighting.sum`, 0 to 1, below 0 for a negative light; 0 where the sum is black. */
  readonly share: number;
  /** Distance (m) from the surface to the centre of the light; null for a directional light, and where no surface was hit. */
  readonly distance: number | null;
}

/**
 * Kind of light without a single position. 'ambient', 'hemisphere', 'light-probe': a light of three's; 'environment': reflected
 * surroundings; 'probes': a baked grid of light probes; 'unlit': colour that no light changes, such as a background, unlit
 * materials and additions by the host's shaders; 'lights': lights beyond `PixelLightingOptions.maxLights`, all together.
 */
export type OtherLight =
  | 'ambient'
  | 'hemisphere'
  | 'light-probe'
  | 'environment'
  | 'probes'
  | 'lightmap'
  | 'emissive'
  | 'fog'
  | 'unlit'
  | 'lights';

/** Light of a pixel that does not come from one light with a position. */
export interface OtherShare {
  readonly kind: OtherLight;
  /** Light object of the kinds 'ambient', 'hemisphere' and 'light-probe'; else null. */
  readonly light: Light | null;
  /** Number of lights of the kind 'lights'; else 1. */
  readonly count: number;
  /** Light that reaches the pixel: linear RGB, before exposure, tone mapping and encoding. */
  readonly color: Color;
  /** Share of the luminance of `PixelLighting.sum`, 0 to 1; 0 where the sum is black. */
  readonly share: number;
}

/** Surface that a pixel shows. */
export interface PixelSurface {
  readonly object: Object3D;
  /** Index of the instance of an InstancedMesh; null for other objects. */
  readonly instanceId: number | null;
  readonly material: Material;
  /** Point that the pixel shows (m, world space). */
  readonly point: Vector3;
  /** Distance from the camera to the point (m). */
  readonly distance: number;
}

/** Program that draws at a pixel. */
export interface PixelProgram {
  /** Name of the material, or of the pass. */
  readonly name: string;
  /** Names of its microshaders, in the order of its source; three's own chunks are left out. */
  readonly microshaders: readonly string[];
}

/** The light of one pixel, split by its sources. */
export interface PixelLighting {
  /** Technique that drew the picture and its parts. */
  readonly technique: TechniqueName;
  /** Column of the pixel, counted from the left edge; `y`: row, from the upper edge. */
  readonly x: number;
  readonly y: number;
  /** Colour of the pixel as drawn by the technique: linear RGB, before tone mapping and encoding, without anti-aliasing. */
  readonly color: Color;
  /** Sum of all shares: linear RGB. */
  readonly sum: Color;
  /** Lights that reach the pixel, or would without shadows: brightest first. */
  readonly lights: readonly LightShare[];
  /** Ambient, environment, emissive and other light that is not in `lights`, brightest first. */
  readonly others: readonly OtherShare[];
  /** Surfaces that the pixel shows, by raycasting, nearest first, up to the first opaque one; none for a background. */
  readonly surfaces: readonly PixelSurface[];
  /** Programs that draw the pixel: those of objects and of full-screen passes. */
  readonly programs: readonly PixelProgram[];
  /** Names of effects left out of the parts, such as anti-aliasing and fog averaged over frames. */
  readonly effectsLeftOut: readonly string[];
  /** Whether the picture changed during the measurement; shares are then from different moments. */
  readonly changed: boolean;
}

/** Options of `explainPixel`. */
export interface PixelLightingOptions {
  /** Size of the camera's picture (pixels). Default: of the drawing buffer. */
  readonly size?: { readonly width: number; readonly height: number };
  /** Maximum number of lights measured separately, at least 1; weaker ones form one share of the kind 'lights'. Default 128. */
  readonly maxLights?: number;
  /** Signal that ends the work: the promise is then rejected with the signal's reason. */
  readonly signal?: AbortSignal;
  /** Called at intervals with the share of the work that is done, 0 to 1. */
  readonly onProgress?: (done: number) => void;
}
