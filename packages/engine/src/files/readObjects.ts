import { shortText } from '@farol/editing';
import { describeValue } from '@farol/editing/fields';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { objectFields } from '../fields/objectFields';
import type { FileComponent, FileObject } from './FarolFile';
import { counted } from '../base/counted';
import { fileLimits } from '../guard/fileLimits';
import type { PathLike } from './FilePath';
import { isRecord, join, type ProblemList, ringOf } from './ProblemList';
import { readComponent } from './readComponent';
import { readLink } from './readLink';

interface ReadObject extends FileObject {
  readonly path: PathLike;
}

function readComponents(
  value: unknown,
  path: PathLike,
  registry: ComponentRegistry,
  problems: ProblemList,
): FileComponent[] {
  const components: FileComponent[] = [];
  const types = new Set<string>();
  problems.array(value, path).forEach((each, i) => {
    const component = readComponent(each, join(path, i), registry, problems);
    if (!component) return;
    const isSecond = types.has(component.type);
    types.add(component.type);
    if (isSecond && registry.types.get(component.type)?.unique) {
      problems.add(join(path, i), `is a second ${component.type}, and an object can have one only. Remove it.`);
    }
    components.push(component);
  });
  return components;
}

const objectKeys = ['id', 'name', 'parent', 'active', 'locked', 'static', 'tags', 'prefab', 'components'];

function readObject(
  value: unknown,
  path: PathLike,
  registry: ComponentRegistry,
  problems: ProblemList,
): ReadObject | null {
  if (!isRecord(value)) {
    problems.record(value, path);
    return null;
  }
  problems.onlyKeys(value, path, objectKeys);
  const id = problems.text(value.id, join(path, 'id'));
  const name = problems.text(value.name, join(path, 'name'), true);
  const parent = value.parent === null ? null : problems.text(value.parent, join(path, 'parent'));
  const active = problems.flag(value.active, join(path, 'active'), true);
  const locked = problems.flag(value.locked, join(path, 'locked'), false);
  const isStatic = problems.flag(value.static, join(path, 'static'), false);
  const listed = value.tags === undefined ? [] : problems.array(value.tags, join(path, 'tags'));
  const tags = listed.map((tag, i) => problems.text(tag, join(join(path, 'tags'), i)));
  const components = readComponents(value.components, join(path, 'components'), registry, problems);
  const prefab = value.prefab === undefined ? null : readLink(value.prefab, join(path, 'prefab'), problems);
  return {
    id,
    name,
    parent,
    ...(active ? {} : { active }),
    ...(locked ? { locked } : {}),
    ...(isStatic ? { static: true } : {}),
    ...(tags.length > 0 ? { tags } : {}),
    ...(prefab ? { prefab } : {}),
    components,
    path,
  };
}

function checkIds(objects: readonly ReadObject[], problems: ProblemList): Map<string, ReadObject> {
  const byId = new Map<string, ReadObject>();
  const owners = new Map<string, { readonly path: PathLike; readonly type: string }>();
  for (const object of objects) {
    const other = byId.get(object.id);
    if (other && object.id)
      problems.add(
        join(object.path, 'id'),
        `'${shortText(object.id)}' is the id of ${other.path} too: ids must differ.`,
      );
    else byId.set(object.id, object);
    for (const { id, type } of object.components) {
      const owner = owners.get(id);
      if (!owner || !id) {
        owners.set(id, { path: object.path, type });
        continue;
      }
      problems.add(
        `${object.path} ${type}`,
        `has the id '${shortText(id)}', which is that of ${owner.path} ${owner.type} too: ids must differ.`,
      );
    }
  }
  return byId;
}

/** Reports missing parents, cycles, and objects nested too deep. Each object is visited once. */
function checkParents(
  objects: readonly ReadObject[],
  byId: ReadonlyMap<string, ReadObject>,
  problems: ProblemList,
): void {
  const depths = new Map<ReadObject, number>();
  let isTold = false;
  for (const object of objects) {
    const way: ReadObject[] = [];
    const places = new Map<ReadObject, number>();
    let above: ReadObject | undefined = object;
    while (above && !depths.has(above) && !places.has(above)) {
      places.set(above, way.length);
      way.push(above);
      above = above.parent === null || above.parent === '' ? undefined : byId.get(above.parent);
    }
    if (above && !depths.has(above)) {
      isTold = true;
      const ring = way.slice(places.get(above)).map(({ id }) => id);
      problems.add(
        join(above.path, 'parent'),
        `makes a cycle: ${ringOf([...ring, above.id], 'below')}. Give one of them another parent.`,
      );
    }
    let depth = (above && depths.get(above)) ?? 0;
    for (const each of way.toReversed()) depths.set(each, ++depth);
    if (depth > fileLimits.depth && !isTold) {
      isTold = true;
      const problem = `makes it ${counted(depth)} objects deep, and ${fileLimits.depth} is the limit: give it a parent nearer to the top.`;
      problems.add(join(object.path, 'parent'), problem);
    }
    if (object.parent && !byId.has(object.parent)) {
      problems.add(
        join(object.path, 'parent'),
        `names the object ${describeValue(object.parent)}, which is not in the file: use null for none.`,
      );
    }
  }
}

function checkReferences(
  objects: readonly ReadObject[],
  byId: ReadonlyMap<string, ReadObject>,
  registry: ComponentRegistry,
  problems: ProblemList,
): void {
  for (const object of objects) {
    for (const { type, values } of object.components) {
      const fields = registry.types.get(type)?.fields;
      if (!fields) continue;
      for (const name of objectFields(fields)) {
        const value = Object.hasOwn(values, name) ? values[name] : null;
        if (typeof value !== 'string' || byId.has(value)) continue;
        problems.add(
          `${object.path} ${type}.${name}`,
          `names the object '${shortText(value)}', which is not in the file.`,
        );
      }
    }
  }
}

function withoutPath(object: ReadObject): FileObject {
  const { path, ...rest } = object;
  void path;
  return rest;
}

/** Reads the objects of a file, and checks ids, parents and references among them. */
export function readObjects(
  value: unknown,
  path: PathLike,
  registry: ComponentRegistry,
  problems: ProblemList,
): FileObject[] {
  const objects = problems
    .array(value, path)
    .map((each, i) => readObject(each, join(path, i), registry, problems))
    .filter((object) => object !== null);
  const byId = checkIds(objects, problems);
  checkParents(objects, byId, problems);
  checkReferences(objects, byId, registry, problems);
  return objects.map(withoutPath);
}
