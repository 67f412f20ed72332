import { shortText } from '@farol/editing';
import type { FileObject } from './FileObject';

export type { PrefabLink } from './FileObject';

/** A tree of objects to be placed any number of times. It is data: nothing of it is drawn. Never changed in place. */
export interface Prefab {
  /** Id of the prefab, and of its root object. */
  readonly id: string;
  readonly name: string;
  /**
   * In tree order; the root, which has no parent, is the first. Those of another prefab within it have a link to that.
   */
  readonly objects: readonly FileObject[];
}

/** Refusal of an operation on a prefab. */
export class PrefabError extends Error {
  constructor(
    readonly prefab: string,
    readonly problem: string,
  ) {
    super(`The prefab '${shortText(prefab)}' ${shortText(problem, 300)}`);
    this.name = 'PrefabError';
  }
}
