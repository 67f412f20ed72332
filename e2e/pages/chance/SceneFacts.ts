/** Three numbers: a place, a direction, angles or factors. */
export type Three = readonly [number, number, number];

/** A material: `type` is a class of three or a shader of `buildMaterial`, the rest are its parameters, textures by name. */
export type MaterialFacts = { readonly type?: string } & Readonly<Record<string, unknown>>;

/** An object that is drawn. */
export interface ThingFacts {
  /** Default 'mesh'. */
  readonly as?: Kind;
  /** Default 'ball'. */
  readonly shape?: Shape;
  /** Other traits of its geometry: attributes that it has or lacks. */
  readonly traits?: readonly Trait[];
  readonly material?: MaterialFacts;
  readonly position?: Three;
  /** Euler angles (rad). */
  readonly rotation?: Three;
  readonly scale?: Three;
  /** Groups round it, the innermost first. */
  readonly parents?: readonly { readonly position?: Three; readonly rotation?: Three; readonly scale?: Three }[];
  readonly renderOrder?: number;
  /** Layer, 1 to 31; default 0. */
  readonly layer?: number;
  readonly castShadow?: boolean;
  readonly receiveShadow?: boolean;
  readonly frustumCulled?: boolean;
  /** A callback of the host's: clears depth, changes its material's colour, or only listens. */
  readonly callback?: 'clears' | 'colours' | 'listens';
}

export const kinds = [
  ...['mesh', 'instanced', 'batched', 'skinned', 'morphed', 'morphed instances', 'levels', 'of materials'],
  ...['line', 'segments', 'loop', 'points', 'sprite'],
] as const;
export type Kind = (typeof kinds)[number] & string;
export type Shape = 'ball' | 'box' | 'knot' | 'sheet' | 'tiles' | 'cone' | 'bowl' | 'crystal';
export type Trait = 'interleaved' | 'without index' | 'wide index' | 'bytes' | 'range' | 'tangents' | 'without normals';

export interface ShadowFacts {
  readonly mapSize?: number;
  readonly bias?: number;
  readonly normalBias?: number;
  readonly radius?: number;
  readonly blurSamples?: number;
  readonly intensity?: number;
  readonly near?: number;
  readonly far?: number;
}

export interface LightFacts {
  /** Default 'point'. A field is a LightField, and single lights to stock three. */
  readonly kind?: 'ambient' | 'hemisphere' | 'directional' | 'point' | 'spot' | 'area' | 'probe' | 'field';
  readonly color?: number;
  readonly ground?: number;
  readonly intensity?: number;
  readonly position?: Three;
  readonly target?: Three;
  readonly distance?: number;
  readonly decay?: number;
  readonly angle?: number;
  readonly penumbra?: number;
  readonly width?: number;
  readonly height?: number;
  /** A spot light's image, by name. */
  readonly map?: string;
  readonly layer?: number;
  readonly shadow?: ShadowFacts;
  /** Lights like it beside it; default 1. */
  readonly count?: number;
  /** Farol's own: shape of an area light. */
  readonly shape?: 'disc' | 'tube';
  /** Farol's own: an area light that casts shadows. */
  readonly castShadow?: boolean;
  /** Farol's own: a photometric profile. */
  readonly profile?: boolean;
  /** Farol's own: image of a point light. */
  readonly cookie?: boolean;
}

export interface WorldFacts {
  /** Name of a texture, or a colour. */
  readonly background?: string | number;
  readonly backgroundBlurriness?: number;
  readonly backgroundIntensity?: number;
  readonly backgroundRotation?: Three;
  readonly environment?: 'room' | 'equirect' | 'cube';
  readonly environmentIntensity?: number;
  readonly environmentRotation?: Three;
  readonly fog?: { readonly color?: number; readonly near?: number; readonly far?: number; readonly density?: number };
  readonly clearColor?: number;
  readonly clearAlpha?: number;
  readonly override?: MaterialFacts;
  /** Planes of the renderer: normal and constant. */
  readonly clippingPlanes?: readonly (readonly [number, number, number, number])[];
  readonly sortObjects?: boolean;
  /** Default PCF, as in three. */
  readonly shadows?: 'basic' | 'vsm';
  /** Farol's own. */
  readonly effects?: readonly string[];
  /** Farol's own. */
  readonly shadowCascades?: number;
  /** Farol's own. */
  readonly lightLayers?: boolean;
}

export interface ViewFacts {
  readonly depth?: 'logarithmic' | 'reversed';
  /** Drawn to; default a target of floats. */
  readonly target?: 'half' | 'bytes' | 'canvas';
  readonly toneMapping?: 'Linear' | 'Reinhard' | 'Cineon' | 'ACESFilmic' | 'AgX' | 'Neutral';
  readonly exposure?: number;
  readonly linearOutput?: boolean;
  readonly camera?: 'orthographic' | 'array' | 'two';
  readonly position?: Three;
  readonly lookAt?: Three;
  /** Vertical field of view (degrees). */
  readonly fov?: number;
  readonly near?: number;
  readonly far?: number;
  readonly zoom?: number;
  /** Part of a larger picture: its left and top (pixels). */
  readonly offset?: readonly [number, number];
  readonly parent?: { readonly position?: Three; readonly rotation?: Three; readonly scale?: Three };
  /** Layers that the camera sees besides 0. */
  readonly layers?: readonly number[];
}

/**
 * A scene as JSON: printed, shrunk, kept in tests and built by `buildScene`. Every property and every element of a list may be
 * left out.
 */
export interface SceneFacts {
  readonly world?: WorldFacts;
  readonly view?: ViewFacts;
  readonly things?: readonly ThingFacts[];
  readonly lights?: readonly LightFacts[];
}
