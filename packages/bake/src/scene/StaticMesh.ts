import type { Material, Mesh, Matrix4 } from 'three';

/** One material of a mesh and the triangles that wear it. */
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
  /** Where its copies stand in the world: one, but for instanced meshes. */
  readonly placements: readonly Matrix4[];
  /** Three a triangle: of a geometry without one, its vertices in turn. */
  readonly index: Uint32Array;
  readonly surfaces: readonly Surface[];
  readonly throwsShadow: boolean;
  /** Whether it gets a lightmap; else it throws shadows and reflects nothing. */
  readonly isLit: boolean;
}
