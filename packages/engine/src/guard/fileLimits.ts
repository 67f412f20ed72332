import { maximumDepth } from '../base/maximumDepth';

/** Limits of a scene. Files beyond one are refused, and so are edits that would exceed it. */
export const fileLimits = {
  /** Greatest depth of the tree of objects. */
  depth: maximumDepth,
  /** Greatest depth of prefabs within prefabs. */
  prefabDepth: 64,
  /** Objects, once each instance of a prefab holds all that its prefab does. */
  objects: 1_000_000,
  /** Lists and objects within one another in the JSON of a file; Farol writes 10 at most. */
  jsonDepth: 32,
  /** Greatest number of problems that are listed. */
  problems: 100,
} as const;
