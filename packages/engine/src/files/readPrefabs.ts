import { describeValue } from '@farol/editing/fields';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { Prefab } from '../core/Prefab';
import { PrefabSizes } from './PrefabSizes';
import type { FileObject } from './FarolFile';
import { counted } from '../base/counted';
import { fileLimits } from '../guard/fileLimits';
import type { PathLike } from './FilePath';
import { join, type ProblemList, ringOf, sampleOf } from './ProblemList';
import { readObjects } from './readObjects';

/** Reports links to unknown prefabs. A link to an object that the prefab no longer has is no problem. */
export function checkLinks(
  objects: readonly FileObject[],
  path: PathLike,
  known: ReadonlySet<string>,
  problems: ProblemList,
): void {
  objects.forEach(({ prefab }, i) => {
    if (!prefab || known.has(prefab.prefab)) return;
    problems.add(
      `${join(path, i)}.prefab.prefab`,
      `names the prefab ${describeValue(prefab.prefab)}, which is not in the file (there: ${sampleOf(known)}): remove "prefab".`,
    );
  });
}

/** Checks that no prefab contains itself, and that expanded instances are neither too deep nor too many objects. */
export function checkSizes(
  prefabs: readonly Prefab[],
  objects: readonly FileObject[],
  path: PathLike,
  problems: ProblemList,
): void {
  const sizes = new PrefabSizes(new Map(prefabs.map((prefab) => [prefab.id, prefab])));
  const indices = new Map(prefabs.map(({ id }, i) => [id, i]));
  for (const ring of sizes.rings) {
    const at = join(path, indices.get(ring[0])!);
    problems.add(at, `holds itself: ${ringOf(ring, 'holds')}. Take the inner one out of its objects.`);
  }
  if (sizes.rings.length > 0) return;
  const tooDeep = prefabs.findIndex(({ id }) => sizes.depthOf(id) > fileLimits.prefabDepth);
  if (tooDeep >= 0) {
    problems.add(join(path, tooDeep), `holds prefabs more than ${fileLimits.prefabDepth} deep: take some out.`);
  }
  const many = `would come to more than ${counted(fileLimits.objects)} objects with all that their prefabs hold: take some out.`;
  const tooLarge = prefabs.findIndex(({ id }) => sizes.sizeOf(id) > fileLimits.objects);
  if (tooLarge >= 0) problems.add(`${join(path, tooLarge)}.objects`, many);
  else if (sizes.sizeOfObjects(objects) > fileLimits.objects) problems.add('objects', many);
}

/** Reads a file's prefabs, and checks that each has one root with the prefab's id and that none contains itself. */
export function readPrefabs(
  value: unknown,
  path: PathLike,
  registry: ComponentRegistry,
  problems: ProblemList,
): Prefab[] {
  const ids = new Set<string>();
  const prefabs = problems.array(value, path).map((each, i): Prefab => {
    const at = join(path, i);
    const record = problems.record(each, at);
    problems.onlyKeys(record, at, ['id', 'name', 'objects']);
    const id = problems.text(record.id, join(at, 'id'));
    if (ids.has(id)) problems.add(join(at, 'id'), `${describeValue(id)} is there twice. Remove one.`);
    ids.add(id);
    const objects = readObjects(record.objects, join(at, 'objects'), registry, problems);
    const roots = objects.filter(({ parent }) => parent === null);
    if (roots.length !== 1 || roots[0].id !== id || objects[0] !== roots[0]) {
      problems.add(
        join(at, 'objects'),
        `must begin with one object that has no parent and the prefab's id ${describeValue(id)}; all others are below it.`,
      );
    }
    return { id, name: problems.text(record.name, join(at, 'name'), true), objects };
  });
  prefabs.forEach(({ objects }, i) => checkLinks(objects, `${join(path, i)}.objects`, ids, problems));
  return prefabs;
}
