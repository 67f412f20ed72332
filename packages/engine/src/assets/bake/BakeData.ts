import type { ProbeBox } from '@farol/renderer/light-probes';

/** A lightmap of a scene. */
export interface LightmapData {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Half floats, RGBA, the row of v = 0 first: irradiance, linear, as three's `lightMap` has it. */
  readonly data: Uint16Array<ArrayBuffer>;
}

/** A mesh of a scene that a lightmap lights. */
export interface LightmappedMesh {
  /** Id of the ObjectRenderer or ModelRenderer that draws it. */
  readonly component: string;
  /** Which of the meshes of the component, in the order of its tree. */
  readonly part: number;
  /** Index of its lightmap. */
  readonly lightmap: number;
  /** Vertices that the geometry had when it was baked: another number is another geometry. */
  readonly sourceVertices: number;
  /** Two a vertex, 0 to 1: where it is in the lightmap. Kept to 1/65535. */
  readonly uv1: Float32Array<ArrayBuffer>;
  /** Three a triangle: vertices of `uv1`. */
  readonly index: Uint32Array<ArrayBuffer>;
  /** One a vertex of `uv1`: the vertex of the geometry that it comes from. */
  readonly sourceVertex: Uint32Array<ArrayBuffer>;
}

/** Light at the probes of a grid. */
export interface ProbeData {
  readonly box: ProbeBox;
  /** 27 a probe, of radiance, as three's SphericalHarmonics3 has them. */
  readonly coefficients: Float32Array<ArrayBuffer>;
}

/** Light of a scene that was baked. */
export interface BakeData {
  /** Signature of the scene at the time of the bake: see `bakeSignature`. */
  readonly signature: string;
  /** Ids of the Light components whose whole light is in it. */
  readonly lights: readonly string[];
  /** Whether the light of sky and environment is in it. */
  readonly hasSky: boolean;
  /** Which set of texture coordinates the lightmaps are read by, 1 to 3. */
  readonly channel: number;
  readonly lightmaps: readonly LightmapData[];
  readonly meshes: readonly LightmappedMesh[];
  readonly probes: ProbeData | null;
}
