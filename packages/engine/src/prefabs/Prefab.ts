import { shortText } from '@farol/renderer';
import type { FileObject } from '../files/FarolFile';

/** A tree of objects to be placed any number of times. It is data: nothing of it is drawn. Never changed in place. */
export interface Prefab {
  /** Also the id of its root object. */
  readonly id: string;
  readonly name: string;
  /** In tree order; the root, which has no parent, is the first. Those of another prefab within it have a link to that. */
  readonly objects: readonly FileObject[];
}

/** What a GameObject is a copy of. */
export interface PrefabLink {
  readonly prefab: string;
  /** Id of the object in the prefab; the prefab's own id for the root of an instance. */
  readonly source: string;
  /**
   * Overrides that happen to have the prefab's present value: 'Light.intensity', 'name'. They stay when it changes. Every
   * other value that differs from the prefab's is an override without being listed.
   */
  readonly pinned?: readonly string[];
}

/** Something that cannot be done with a prefab. */
export class PrefabError extends Error {
  constructor(
    readonly prefab: string,
    readonly problem: string,
  ) {
    super(`The prefab '${shortText(prefab)}' ${shortText(problem, 300)}`);
    this.name = 'PrefabError';
  }
}
