import { FileError } from '../guard/FileError';
import { fileLimits } from './fileLimits';

/**
 * Checks the nesting depth of a file's values, without recursion.
 * @throws FileError beyond the limit, or for a cyclic value
 */
export function checkDepth(value: unknown): void {
  let level: unknown[] = [value];
  for (let depth = 0; level.length > 0; depth++) {
    if (depth > fileLimits.jsonDepth) {
      const problem = `The file holds lists or objects more than ${fileLimits.jsonDepth} deep in one another: it is damaged, or not a scene of Farol.`;
      throw new FileError([{ path: '', problem }]);
    }
    const next: unknown[] = [];
    for (const each of level) {
      if (typeof each !== 'object' || each === null) continue;
      for (const inner of Object.values(each)) if (typeof inner === 'object' && inner !== null) next.push(inner);
    }
    level = next;
  }
}
