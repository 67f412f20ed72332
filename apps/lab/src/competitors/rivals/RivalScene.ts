/**
 * A case as plain data, for another engine. Lengths are metres, angles radians, colours linear RGB with sRGB's primaries;
 * the world is right-handed with y up.
 */
export interface RivalScene {
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  readonly camera: RivalCamera;
  /** Clear colour: sRGB, not linear; null for transparent black. */
  readonly background: Rgb | null;
  /** Sum of the ambient lights (radiance times π, as three's irradiance). */
  readonly ambient: Rgb;
  readonly hemispheres: readonly RivalHemisphere[];
  readonly directionals: readonly RivalDirectional[];
  readonly spots: readonly RivalSpot[];
  readonly points: RivalPoints;
  readonly textures: readonly RivalTexture[];
  readonly materials: readonly RivalMaterial[];
  readonly geometries: readonly RivalGeometry[];
  /** Visible meshes, in drawing order if `isOrdered`. */
  readonly meshes: readonly RivalMesh[];
  /** Whether the scene sets the order of its opaque meshes (three's `renderOrder`); otherwise engines sort them. */
  readonly isOrdered: boolean;
}

export type Rgb = readonly [r: number, g: number, b: number];
export type Xyz = readonly [x: number, y: number, z: number];

export interface RivalCamera {
  /** Vertical field of view (radians). */
  readonly fov: number;
  readonly near: number;
  readonly far: number;
  readonly placement: RivalPlacement;
}

/** World placement of an object in 10 numbers: position x y z, rotation as a unit quaternion x y z w, scale x y z. */
export type RivalPlacement = Float32Array;

/** Irradiance from `ground` to `sky` along `up`. */
export interface RivalHemisphere {
  readonly sky: Rgb;
  readonly ground: Rgb;
  /** Unit vector towards the sky (world). */
  readonly up: Xyz;
}

export interface RivalDirectional {
  /** Colour times intensity (lux). */
  readonly colour: Rgb;
  /** Unit vector along which the light shines. */
  readonly direction: Xyz;
}

export interface RivalSpot {
  /** Colour times intensity (candela). */
  readonly colour: Rgb;
  readonly position: Xyz;
  /** Unit vector along which the light shines. */
  readonly direction: Xyz;
  /** Range of the light (m); more than 0. */
  readonly range: number;
  /** Half the angle of the cone (radians). */
  readonly angle: number;
  /** Half the angle of the cone of full intensity (radians), at most `angle`. */
  readonly innerAngle: number;
}

/** Point lights; the i-th entry of each array is of light `i`. Falloff 1 / d², windowed as in KHR_lights_punctual. */
export interface RivalPoints {
  readonly count: number;
  /** [count, 3]: colour times intensity (candela). */
  readonly colours: Float32Array;
  /** [count]: ranges of the lights (m); more than 0. */
  readonly ranges: Float32Array;
  /** [count, 3]: world positions; updated before each `RivalDrawing.moveLights`. */
  readonly positions: Float32Array;
}

export type RivalWrap = 'repeat' | 'mirror' | 'clamp';

export interface RivalTexture {
  readonly width: number;
  readonly height: number;
  /** [height, width, 4], the row at v = 0 first. */
  readonly pixels: Uint8Array;
  /** Whether the colours are sRGB, decoded by the sampler. */
  readonly isSrgb: boolean;
  readonly wrapU: RivalWrap;
  readonly wrapV: RivalWrap;
  readonly isMagLinear: boolean;
  /** Filter between mip levels; 'none' for a texture without mip levels. */
  readonly mipmaps: 'none' | 'nearest' | 'linear';
  readonly isMinLinear: boolean;
  /** Anisotropic filtering, 1 (none) or more. */
  readonly anisotropy: number;
}

/** Use of a texture by a material: texture coordinates times `scale`, plus `offset`. */
export interface RivalMap {
  /** Index in `RivalScene.textures`. */
  readonly texture: number;
  readonly scale: readonly [u: number, v: number];
  readonly offset: readonly [u: number, v: number];
}

export interface RivalMaterial {
  readonly name: string;
  /** Whether the material is lit; otherwise only its colour is shown. */
  readonly isLit: boolean;
  readonly colour: Rgb;
  readonly map: RivalMap | null;
  readonly normalMap: RivalMap | null;
  /** Factors of the normal map's x and y. */
  readonly normalScale: readonly [x: number, y: number];
  /** Roughness, 0 to 1, times the map's green. */
  readonly roughness: number;
  /** Metalness, 0 to 1, times the map's blue. */
  readonly metalness: number;
  /** Map with roughness in green and metalness in blue. */
  readonly roughnessMetalnessMap: RivalMap | null;
  readonly emissive: Rgb;
  readonly emissiveMap: RivalMap | null;
  readonly isDoubleSided: boolean;
  readonly hasVertexColours: boolean;
  /** Alpha below which fragments are discarded; 0 for none. */
  readonly alphaTest: number;
  readonly isTransparent: boolean;
  readonly opacity: number;
}

export interface RivalGeometry {
  /** Positions, [n, 3]. */
  readonly positions: Float32Array;
  /** Normals, [n, 3], unit vectors. */
  readonly normals: Float32Array;
  /** Texture coordinates, [n, 2]; null for none. */
  readonly uvs: Float32Array | null;
  /** Vertex colours, [n, 4], linear; null for none. */
  readonly colours: Float32Array | null;
  /** Vertex indices, three for each triangle, counter-clockwise seen from its front. */
  readonly indices: Uint16Array | Uint32Array;
}

export interface RivalMesh {
  readonly geometry: number;
  readonly material: number;
  readonly placement: RivalPlacement;
  readonly instances: RivalInstances | null;
}

export interface RivalInstances {
  readonly count: number;
  /** [count, 16]: from instance to mesh, column-major; the scene's own array, which may change between frames. */
  readonly matrices: Float32Array;
  /** Factors of the material's colour, [count, 3]; null for none. */
  readonly colours: Float32Array | null;
}

/** Another engine, opened for a case. */
export interface RivalDrawing {
  readonly gl: WebGL2RenderingContext;
  /** Makes the engine's scene, waits for its programs and draws it: the whole first frame. */
  drawFirst(): Promise<void>;
  render(): void;
  /** Copies the placement of `RivalScene.camera`. */
  moveCamera(): void;
  /** Copies the placement of a mesh of `RivalScene.meshes`. */
  moveMesh(mesh: number): void;
  /** Copies `points.positions`; nothing else of the lights has changed. */
  moveLights(points: RivalPoints): void;
  setLights(points: RivalPoints): void;
  /** Copies the matrices of a mesh's instances. */
  moveInstances(mesh: number): void;
  /** Number of lights that were missing in at least one cluster of the last frame, because the cluster was full. */
  dropped(): number;
  dispose(): void;
}

/** Exports of `rivals/playcanvas.js` and `rivals/babylon.js`. */
export interface RivalModule {
  /** Version of the engine's package. */
  readonly version: string;
  /** Creates the context; `drawFirst` creates everything else. @throws Error naming what the engine does not support */
  open(canvas: HTMLCanvasElement, scene: RivalScene, signal: AbortSignal): RivalDrawing;
}
