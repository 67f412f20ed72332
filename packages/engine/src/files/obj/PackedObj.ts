/** An OBJ and what belongs to it, as one file. */
export interface PackedObj {
  /** A GLB: nothing beside it is needed. */
  readonly glb: ArrayBuffer;
  /** What is missing, or was left out, and what to do: sentences that name the OBJ. Empty when it came in whole. */
  readonly notes: readonly string[];
  /** Paths of the files that belong to it: materials and textures. */
  readonly used: ReadonlySet<string>;
}
