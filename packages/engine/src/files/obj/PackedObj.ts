/** An OBJ and what belongs to it, as one file. */
export interface PackedObj {
  /** A GLB: nothing beside it is needed. */
  readonly glb: ArrayBuffer;
  /** Sentences that name the OBJ, say what is missing or was left out, and how to mend it. Empty when nothing is. */
  readonly notes: readonly string[];
  /** Paths of the files that belong to it: materials and textures. */
  readonly used: ReadonlySet<string>;
}
