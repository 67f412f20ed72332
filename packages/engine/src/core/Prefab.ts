import { shortText } from '@farol/editing';
import type { FileObject } from './FileObject';

export type { PrefabLink } from './FileObject';

/** A tree of objects that can be placed any number of times. Immutable data; not drawn itself. */
export interface Prefab {
  /** Id of the prefab, and of its root object. */
  readonly id: string;
  readonly name: string;
  /** Objects in tree order, the root (without a parent) first. Objects of nested prefabs have a `prefab` link. */
  readonly objects: readonly FileObject[];
}

/** Error that refuses an operation on a prefab. */
export class PrefabError extends Error {
  constructor(
    readonly prefab: string,
    readonly problem: string,
  ) {
    super(`The prefab '${shortText(prefab)}' ${shortText(problem, 300)}`);
    this.name = 'PrefabError';
  }
}
