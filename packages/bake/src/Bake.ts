import type { Mesh } from 'three';
import type { BakedProbes } from './probes/BakedProbes';

/** A lightmap of a bake. */
export interface BakedLightmap {
  /** Size of the lightmap (texels). */
  readonly width: number;
  readonly height: number;
  /**
   * Half floats, RGBA, width × height × 4, the row of v = 0 first: irradiance, linear, as three's `lightMap` has it at
   * an intensity of 1 (a light of intensity 1 that falls straight on a surface gives 1). Alpha is 1.
   */
  readonly data: Uint16Array;
}

/** A mesh that is lit by a lightmap. Vertices are split where the charts of its surface meet. */
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
  /**
   * Set of UVs that the lightmaps are read by, as a texture's `channel`: 1, but for geometries that have a second set.
   */
  readonly channel: number;
  /** Whether the meshes of the scene show the lightmaps at present. */
  readonly isApplied: boolean;
  /**
   * Gives each mesh a geometry with the second UVs and a clone of its material with the lightmap, and hides the lights
   * that were baked whole. No geometry, material or texture of the host's is changed. Does nothing when it is applied.
   */
  apply(): void;
  /**
   * Gives the meshes and lights back their own geometries, materials and layers. Does nothing when the bake is not
   * applied.
   */
  remove(): void;
  /** Removes the bake from the scene, and frees its textures, geometries and materials. */
  dispose(): void;
}
