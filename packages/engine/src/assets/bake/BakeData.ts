import type { ProbeBox } from '@farol/renderer/light-probes';

/** Pixels of a baked lightmap. */
export interface LightmapData {
  /** Size of the lightmap (texels). */
  readonly width: number;
  readonly height: number;
  /** Half floats, RGBA, the row of v = 0 first: linear irradiance in the convention of three's `lightMap`. */
  readonly data: Uint16Array<ArrayBuffer>;
}

/** A mesh of a scene that a lightmap lights. */
export interface LightmappedMesh {
  /** Id of the ObjectRenderer or ModelRenderer of the mesh. */
  readonly component: string;
  /** Index among the component's meshes, in tree order. */
  readonly part: number;
  /** Index of the mesh's lightmap. */
  readonly lightmap: number;
  /** Vertex count of the geometry at the bake; another count means another geometry. */
  readonly sourceVertices: number;
  /** Lightmap coordinates, two per vertex, 0 to 1; stored in steps of 1/65535. */
  readonly uv1: Float32Array<ArrayBuffer>;
  /** Vertex indices into `uv1`, three per triangle. */
  readonly index: Uint32Array<ArrayBuffer>;
  /** For each vertex of `uv1`, the index of the geometry's vertex that it is a copy of. */
  readonly sourceVertex: Uint32Array<ArrayBuffer>;
}

/** Light probes of a bake. */
export interface ProbeData {
  readonly box: ProbeBox;
  /** Radiance coefficients, 27 per probe, ordered as in three's SphericalHarmonics3. */
  readonly coefficients: Float32Array<ArrayBuffer>;
}

/** Baked light of a scene, in the form of its file. */
export interface BakeData {
  /** Signature of the scene at the time of the bake: see `bakeSignature`. */
  readonly signature: string;
  /** Ids of Light components whose direct and indirect light is baked. */
  readonly lights: readonly string[];
  /** Whether light of sky and environment is baked. */
  readonly hasSky: boolean;
  /** Index of the UV set of the lightmaps, 1 to 3. */
  readonly channel: number;
  readonly lightmaps: readonly LightmapData[];
  readonly meshes: readonly LightmappedMesh[];
  readonly probes: ProbeData | null;
}
