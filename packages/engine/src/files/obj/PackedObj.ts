/** An OBJ file with its materials and textures, packed as one GLB. */
export interface PackedObj {
  /** GLB file that contains meshes, materials and pictures. */
  readonly glb: ArrayBuffer;
  /** Sentences that name the OBJ, missing or omitted parts, and the remedy; empty when complete. */
  readonly notes: readonly string[];
  /** Paths of the material and texture files that were packed. */
  readonly used: ReadonlySet<string>;
}
