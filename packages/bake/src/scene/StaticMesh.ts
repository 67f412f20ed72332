import type { BufferGeometry, Color, Material, Mesh, Matrix4 } from 'three';

/** Material of a mesh, with the range of the mesh's indices that it draws. */
export interface Surface {
  readonly material: Material;
  /** First index of the range. */
  readonly start: number;
  readonly count: number;
}

/** A static mesh, in the form that the tracer needs. */
export interface StaticMesh {
  readonly mesh: Mesh;
  /** Name of the mesh in messages. */
  readonly name: string;
  /** Geometry of the mesh, skinned in its present pose. */
  readonly geometry: BufferGeometry;
  /** World matrices: one, or one for each instance. */
  readonly placements: readonly Matrix4[];
  /** Vertex indices, three per triangle; generated for a geometry without an index. */
  readonly index: Uint32Array;
  readonly surfaces: readonly Surface[];
  readonly throwsShadow: boolean;
  /** Colour factors of the mesh's instances; null without instance colours. */
  readonly colours: readonly Color[] | null;
  /** Whether the mesh gets a lightmap. */
  readonly isLit: boolean;
  /**
   * Whether the mesh reflects light though it has no lightmap; a mesh that is neither lit nor reflecting only casts
   * shadows.
   */
  readonly isReflecting: boolean;
}
