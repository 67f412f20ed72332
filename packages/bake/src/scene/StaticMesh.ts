import type { BufferGeometry, Color, Material, Mesh, Matrix4 } from 'three';

/** A material of a mesh with its triangles. */
export interface Surface {
  readonly material: Material;
  /** First index of its triangles, and how many indices. */
  readonly start: number;
  readonly count: number;
}

/** A mesh that stays where it is, as the tracer needs it. */
export interface StaticMesh {
  readonly mesh: Mesh;
  /** How the mesh is called in sentences. */
  readonly name: string;
  /** Geometry of the mesh, skinned in its present pose. */
  readonly geometry: BufferGeometry;
  /** World matrices of its copies: one, more for instanced meshes. */
  readonly placements: readonly Matrix4[];
  /** Three a triangle: of a geometry without one, its vertices in turn. */
  readonly index: Uint32Array;
  readonly surfaces: readonly Surface[];
  readonly throwsShadow: boolean;
  /** Colour factors of the mesh's instances; null without instance colours. */
  readonly colours: readonly Color[] | null;
  /** Whether it gets a lightmap that it keeps. */
  readonly isLit: boolean;
  /** Whether it gets none, and reflects light all the same; else what has no lightmap throws shadows alone. */
  readonly isReflecting: boolean;
}
