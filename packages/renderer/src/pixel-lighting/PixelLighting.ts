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
  /** Light that would reach it if nothing cast a shadow in this light: linear RGB. */
  readonly unshadowed: Color;
  /** Part of the luminance of `PixelLighting.sum`, 0 to 1, below 0 for light that is taken away; 0 where the sum is black. */
  readonly share: number;
  /** Distance (m) from the surface to the centre of the light; null for a directional light, and where no surface was hit. */
  readonly distance: number | null;
}

/**
 * Kind of light that is of no one place. 'ambient', 'hemisphere', 'light-probe': a light of three's; 'environment': reflected
 * surroundings; 'probes': a baked grid of light probes; 'unlit': what no light changes, such as a background, materials that are not
 * lit and what a shader of the host's adds; 'lights': lights beyond `PixelLightingOptions.maxLights`, all together.
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

/** Light of a pixel that is not of one light with a place. */
export interface OtherShare {
  readonly kind: OtherLight;
  /** The light of an 'ambient', 'hemisphere' or 'light-probe'; else null. */
  readonly light: Light | null;
  /** Number of lights of the kind 'lights'; else 1. */
  readonly count: number;
  /** Linear RGB, before exposure, tone mapping and encoding. */
  readonly color: Color;
  /** Part of the luminance of `PixelLighting.sum`, 0 to 1; 0 where the sum is black. */
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
  /** Distance from the camera (m). */
  readonly distance: number;
}

/** Program that draws at a pixel. */
export interface PixelProgram {
  /** Name of the material, or of the pass. */
  readonly name: string;
  /** Names of its microshaders, in the order of its source; three's own chunks are left out. */
  readonly microshaders: readonly string[];
}

/** The light of one pixel, taken apart. */
export interface PixelLighting {
  /** Technique that drew the picture, and the parts. */
  readonly technique: TechniqueName;
  /** Place of the pixel: from the left edge, from the upper edge (pixels). */
  readonly x: number;
  readonly y: number;
  /** The pixel as the technique draws it: linear RGB, before exposure, tone mapping and encoding, without smoothed edges. */
  readonly color: Color;
  /** Sum of all shares: linear RGB. */
  readonly sum: Color;
  /** Lights that reach the pixel, or would without shadows: brightest first. */
  readonly lights: readonly LightShare[];
  /** Ambient, environment, emissive and other light that no light of `lights` gives, brightest first. */
  readonly others: readonly OtherShare[];
  /** Surfaces that the pixel shows, nearest first, down to the first opaque one; none for a background. Found by ray. */
  readonly surfaces: readonly PixelSurface[];
  /** Programs that draw the pixel: those of objects and of full-screen passes. */
  readonly programs: readonly PixelProgram[];
  /** Names of effects that the parts are drawn without, such as anti-aliasing and fog that gathers frames. */
  readonly effectsLeftOut: readonly string[];
  /** Whether the picture changed meanwhile; shares are then of several moments. */
  readonly changed: boolean;
}

/** Choices of `explainPixel`. */
export interface PixelLightingOptions {
  /** Size of the picture that the camera fills (pixels). Default: of the drawing buffer. */
  readonly size?: { readonly width: number; readonly height: number };
  /** Maximum number of lights told apart, at least 1; the weaker ones are one share of the kind 'lights'. Default 128. */
  readonly maxLights?: number;
  /** Ends the work: the promise is then rejected with the signal's reason. */
  readonly signal?: AbortSignal;
  /** Called now and then with the part of the work that is done, 0 to 1. */
  readonly onProgress?: (done: number) => void;
}
