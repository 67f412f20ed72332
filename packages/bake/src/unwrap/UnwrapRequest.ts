/** A surface to cut into charts; meshes that differ only in their transforms share one. */
export interface SurfaceToUnwrap {
  /** Three numbers per vertex (m): the mesh's positions in the scale of the world. */
  readonly positions: Float32Array;
  /** Unit normals, three numbers per vertex; null for face normals. */
  readonly normals: Float32Array | null;
  /** Vertex indices, three per triangle. */
  readonly index: Uint32Array;
}

/** Density, padding and size of lightmaps. */
export interface PackOptions {
  /** Width and height of a lightmap in texels. */
  readonly size: number;
  /** Distance between charts (texels). */
  readonly padding: number;
  /** Texels per metre; null: as many as fit into one lightmap. */
  readonly texelsPerMetre: number | null;
}

export interface UnwrapRequest extends PackOptions {
  readonly surfaces: readonly SurfaceToUnwrap[];
  /** Index of the surface of each mesh. */
  readonly meshes: readonly number[];
}

/** A mesh's coordinates in a lightmap: see BakedMesh. Equal meshes may share arrays. */
export interface UnwrappedMesh {
  readonly lightmap: number;
  readonly uv1: Float32Array;
  readonly index: Uint32Array;
  readonly sourceVertex: Uint32Array;
}

export interface Unwrapped {
  readonly meshes: readonly UnwrappedMesh[];
  /** Resulting texels per metre, one number per lightmap: fewer than requested where a mesh exceeds a lightmap. */
  readonly texelsPerMetre: readonly number[];
}
