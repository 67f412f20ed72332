/** JSON values. */
type Json = string | number | boolean | null | undefined | readonly Json[] | { readonly [name: string]: Json };
/** Way to a part of a value: names of properties and numbers of elements. */
type Path = readonly (string | number)[];

const isParent = (value: Json): value is readonly Json[] | { readonly [name: string]: Json } =>
  typeof value === 'object' && value !== null;

/** Elements of these are one value: a place, a plane, a factor. */
const isVector = (value: Json): boolean => Array.isArray(value) && value.every((item) => typeof item === 'number');

/** Parts of a value that could be left out, a level of depth at a time: parts of the first come before parts of parts. */
function partsAt(value: Json, depth: number, path: Path = []): Path[] {
  if (!isParent(value) || isVector(value)) return [];
  const entries = Array.isArray(value) ? value.map((item, i) => [i, item] as const) : Object.entries(value);
  if (depth === 0) return entries.map(([name]) => [...path, name]);
  return entries.flatMap(([name, item]) => partsAt(item as Json, depth - 1, [...path, name]));
}

/** The value without some of its parts. */
function without(value: Json, paths: readonly Path[]): Json {
  if (paths.length === 0 || !isParent(value)) return value;
  const gone = new Set(paths.filter(({ length }) => length === 1).map(([name]) => String(name)));
  const inner = (name: string) =>
    paths.filter((path) => path.length > 1 && String(path[0]) === name).map((path) => path.slice(1));
  const kept = Object.entries(value)
    .filter(([name]) => !gone.has(name))
    .map(([name, item]) => [name, without(item as Json, inner(name))] as const);
  return Array.isArray(value) ? kept.map(([, item]) => item) : Object.fromEntries(kept);
}

/** The value with each whole `count` of its parts halved. */
function halved(value: Json): Json {
  if (!isParent(value)) return value;
  if (Array.isArray(value)) return value.map(halved);
  return Object.fromEntries(
    Object.entries(value).map(([name, item]) => [
      name,
      name === 'count' && typeof item === 'number' ? Math.max(1, item >> 1) : halved(item as Json),
    ]),
  );
}

/**
 * Takes away halves, quarters and single parts of a description while it still fails, from its outermost parts to the
 * innermost ones, until nothing more can go.
 *
 * @param fails - whether a description still has the fault
 * @param tries - how often `fails` is asked, at most
 */
export function shrink<T extends object>(given: T, fails: (tried: T) => boolean, tries = 200): T {
  let left = tries;
  let value = given as unknown as Json;
  const attempt = (tried: Json): boolean => {
    if (left <= 0 || JSON.stringify(tried) === JSON.stringify(value)) return false;
    left--;
    if (!fails(tried as unknown as T)) return false;
    value = tried;
    return true;
  };
  let again = true;
  while (again) {
    again = false;
    while (attempt(halved(value))) again = true;
    for (let depth = 0; depth < 6; depth++) {
      for (
        let size = Math.ceil(partsAt(value, depth).length / 2);
        size >= 1;
        size = size === 1 ? 0 : Math.ceil(size / 2)
      ) {
        for (let at = 0; at < partsAt(value, depth).length;) {
          if (attempt(without(value, partsAt(value, depth).slice(at, at + size)))) again = true;
          else at += size;
        }
      }
    }
  }
  return value as unknown as T;
}
