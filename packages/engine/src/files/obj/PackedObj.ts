/** An OBJ and what belongs to it, as one file. */
export interface PackedObj {
  /** GLB file that contains meshes, materials and pictures. */
  readonly glb: ArrayBuffer;
  /** Sentences that name the OBJ, missing or omitted parts, and the remedy; empty when complete. */
  readonly notes: readonly string[];
  /** Paths of the files that belong to it: materials and textures. */
  readonly used: ReadonlySet<string>;
}
