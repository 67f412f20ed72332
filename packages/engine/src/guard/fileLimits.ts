import { maximumDepth } from '../base/maximumDepth';

/** Limits of a scene. Files beyond one are refused, and so are edits that would exceed it. */
export const fileLimits = {
  /** Greatest depth of the tree of objects. */
  depth: maximumDepth,
  /** Greatest depth of prefabs within prefabs. */
  prefabDepth: 64,
  /** Greatest number of objects, with all instances of prefabs expanded. */
  objects: 1_000_000,
  /** Greatest nesting depth of lists and objects in a file's JSON; files of Farol have 10 at most. */
  jsonDepth: 32,
  /** Greatest number of problems in a message. */
  problems: 100,
} as const;
