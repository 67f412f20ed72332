import type { Mesh } from 'three';
import type { BakedProbes } from './probes/BakedProbes';

/** A lightmap of a bake. */
export interface BakedLightmap {
  /** Size of the lightmap (texels). */
  readonly width: number;
  readonly height: number;
  /**
   * Half floats, RGBA, width × height × 4, the row of v = 0 first: irradiance, linear, in the convention of three's
   * `lightMap` at intensity 1 (a light of intensity 1 that shines perpendicularly on a surface gives 1). Alpha is 1.
   */
  readonly data: Uint16Array;
}

/** A lightmapped mesh. Its vertices are split at chart borders. */
export interface BakedMesh {
  readonly mesh: Mesh;
  /** Index in {@link Bake.lightmaps}. */
  readonly lightmap: number;
  /** Lightmap coordinates, two numbers a vertex, 0 to 1. */
  readonly uv1: Float32Array;
  /** Vertex indices into `uv1`, three per triangle, in the mesh's order of triangles. Groups stay unchanged. */
  readonly index: Uint32Array;
  /** Source vertex in the mesh's geometry, one per vertex of `uv1`. */
  readonly sourceVertex: Uint32Array;
}

/** Baked light of a scene, as lightmaps. */
export interface Bake {
  readonly lightmaps: readonly BakedLightmap[];
  readonly meshes: readonly BakedMesh[];
  /** Light at the points `options.probes`; null when no points were given. */
  readonly probes: BakedProbes | null;
  /** UV set of the lightmaps, as in `Texture.channel`: 1, unless a geometry of the scene already uses that set. */
  readonly channel: number;
  /** Whether the meshes of the scene show the lightmaps now. */
  readonly isApplied: boolean;
  /**
   * Gives each mesh a geometry with the lightmap UVs and a copy of its material with the lightmap, and switches off
   * fully baked lights. The host's geometries, materials and textures are not changed. No effect when already applied.
   */
  apply(): void;
  /** Restores the geometries, materials and layers of meshes and lights. No effect when the bake is not applied. */
  remove(): void;
  /** Removes the bake from the scene, and frees its textures, geometries and materials. */
  dispose(): void;
}
