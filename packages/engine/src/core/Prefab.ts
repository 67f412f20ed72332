import { shortText } from '@farol/editing';
export type { Prefab, PrefabLink } from '../files/FarolFile';

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
