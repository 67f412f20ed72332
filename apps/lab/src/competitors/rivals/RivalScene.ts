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
  /** Visible meshes; in the order of drawing if `isOrdered`. */
  readonly meshes: readonly RivalMesh[];
  /** Whether the scene sets the order of its opaque meshes (three's `renderOrder`); engines sort by themselves otherwise. */
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

/** World placement of an object: [10], position x y z, rotation as a unit quaternion x y z w, scale x y z. */
export type RivalPlacement = Float32Array;

/** Irradiance from `ground` to `sky` along `up`. */
export interface RivalHemisphere {
  readonly sky: Rgb;
  readonly ground: Rgb;
  /** Unit vector. */
  readonly up: Xyz;
}

export interface RivalDirectional {
  /** Times the intensity (lux). */
  readonly colour: Rgb;
  /** Unit vector along which the light shines. */
  readonly direction: Xyz;
}

export interface RivalSpot {
  /** Times the intensity (candela). */
  readonly colour: Rgb;
  readonly position: Xyz;
  /** Unit vector along which the light shines. */
  readonly direction: Xyz;
  /** Range of the light; more than 0. */
  readonly range: number;
  /** Half the angle of the cone. */
  readonly angle: number;
  /** Half the angle of the cone of full intensity, `angle` at most. */
  readonly innerAngle: number;
}

/** Point lights; the i-th part of each array is light `i`. Falloff 1 / d², windowed as in KHR_lights_punctual. */
export interface RivalPoints {
  readonly count: number;
  /** [count, 3]: colour times intensity (candela). */
  readonly colours: Float32Array;
  /** [count]: ranges of the lights; more than 0. */
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
  /** Filter between mip levels; `none`: the texture has no mip levels. */
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
  /** Whether the material is lit; otherwise its colour alone is shown. */
  readonly isLit: boolean;
  readonly colour: Rgb;
  readonly map: RivalMap | null;
  readonly normalMap: RivalMap | null;
  /** Factors of the normal map's x and y. */
  readonly normalScale: readonly [x: number, y: number];
  /** 0 to 1, times the map's green. */
  readonly roughness: number;
  /** 0 to 1, times the map's blue. */
  readonly metalness: number;
  /** Roughness in green, metalness in blue. */
  readonly roughnessMetalnessMap: RivalMap | null;
  readonly emissive: Rgb;
  readonly emissiveMap: RivalMap | null;
  readonly isDoubleSided: boolean;
  readonly hasVertexColours: boolean;
  /** Fragments with less alpha are discarded; 0 for none. */
  readonly alphaTest: number;
  readonly isTransparent: boolean;
  readonly opacity: number;
}

export interface RivalGeometry {
  /** [n, 3] */
  readonly positions: Float32Array;
  /** [n, 3], unit vectors. */
  readonly normals: Float32Array;
  /** [n, 2]; null without texture coordinates. */
  readonly uvs: Float32Array | null;
  /** [n, 4], linear; null without vertex colours. */
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
  /** [count, 16]: instance to mesh, 4 × 4, column by column; the scene's own array, which may change between frames. */
  readonly matrices: Float32Array;
  /** [count, 3]: factors of the material's colour; null for none. */
  readonly colours: Float32Array | null;
}

/** Another engine, open for a case. */
export interface RivalDrawing {
  readonly gl: WebGL2RenderingContext;
  /** Makes the engine's scene, waits for its programs and draws it: the whole first frame. */
  drawFirst(): Promise<void>;
  render(): void;
  /** Copies the placement of `RivalScene.camera`. */
  moveCamera(): void;
  /** Copies the placement of a mesh of `RivalScene.meshes`. */
  moveMesh(mesh: number): void;
  /** Copies `points.positions`; the lights are unchanged otherwise. */
  moveLights(points: RivalPoints): void;
  setLights(points: RivalPoints): void;
  /** Copies the matrices of a mesh's instances. */
  moveInstances(mesh: number): void;
  /** Lights missing in some full cell of the last frame. */
  dropped(): number;
  dispose(): void;
}

/** Exports of `rivals/playcanvas.js` and `rivals/babylon.js`. */
export interface RivalModule {
  /** Version of the engine's package. */
  readonly version: string;
  /** Makes the context; `drawFirst` makes everything else. @throws Error that names what the engine cannot do */
  open(canvas: HTMLCanvasElement, scene: RivalScene, signal: AbortSignal): RivalDrawing;
}
