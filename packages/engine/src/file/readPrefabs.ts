import type { ComponentRegistry } from '../components/ComponentRegistry';
import { describeValue } from '../fields/checkFieldValue';
import type { Prefab } from '../prefabs/Prefab';
import type { FileObject } from './FarolFile';
import { join, type ProblemList } from './ProblemList';
import { readObjects } from './readObjects';

/** Names links to prefabs that are not there. A source that is not in its prefab any more is no problem: it was removed. */
export function checkLinks(
  objects: readonly FileObject[],
  path: string,
  prefabs: readonly Prefab[],
  problems: ProblemList,
): void {
  const known = new Set(prefabs.map(({ id }) => id));
  objects.forEach(({ prefab }, i) => {
    if (!prefab || known.has(prefab.prefab)) return;
    const names = [...known].join(', ') || 'none';
    problems.add(
      `${join(path, i)}.prefab.prefab`,
      `names the prefab ${describeValue(prefab.prefab)}, which is not in the file (there: ${names}): remove "prefab".`,
    );
  });
}

function checkNesting(prefabs: readonly Prefab[], path: string, problems: ProblemList): void {
  const byId = new Map(prefabs.map((prefab) => [prefab.id, prefab]));
  const visit = (prefab: Prefab, above: readonly string[]): string[] | null => {
    if (above.includes(prefab.id)) return [...above, prefab.id];
    const inner = new Set(prefab.objects.flatMap((object) => object.prefab?.prefab ?? []));
    for (const id of inner) {
      const next = byId.get(id);
      const ring = next && visit(next, [...above, prefab.id]);
      if (ring) return ring;
    }
    return null;
  };
  prefabs.forEach((prefab, i) => {
    const ring = visit(prefab, []);
    if (ring?.at(-1) === prefab.id) {
      problems.add(join(path, i), `holds itself: ${ring.join(' in ')}. Take the inner one out of its objects.`);
    }
  });
}

/** Reads the prefabs of a file, and checks that each has one root of its own id and that none is within itself. */
export function readPrefabs(
  value: unknown,
  path: string,
  registry: ComponentRegistry,
  problems: ProblemList,
): Prefab[] {
  const ids = new Set<string>();
  const prefabs = problems.array(value, path).map((each, i): Prefab => {
    const at = join(path, i);
    const record = problems.record(each, at);
    problems.onlyKeys(record, at, ['id', 'name', 'objects']);
    const id = problems.text(record.id, join(at, 'id'));
    if (ids.has(id)) problems.add(join(at, 'id'), `'${id}' is there twice. Remove one.`);
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
  prefabs.forEach(({ objects }, i) => checkLinks(objects, `${join(path, i)}.objects`, prefabs, problems));
  checkNesting(prefabs, path, problems);
  return prefabs;
}
