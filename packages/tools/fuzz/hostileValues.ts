import type { FuzzRandom } from './FuzzRandom';

/** Placeholder that `textOf` replaces with 1e999, which JSON.parse reads as Infinity. */
const INFINITE = '\u0001infinite\u0001';

const nested = (depth: number, isList: boolean): unknown => {
  let value: unknown = 1;
  for (let i = 0; i < depth; i++) value = isList ? [value] : { a: value };
  return value;
};

const numbers = [0, -0, -1, 1, 0.5, 3, 1e-320, 1e12, 1e30, 1e308, -1e308, 2 ** 53, 4e9, 65_535, 500, INFINITE];
const texts = [
  '',
  'a',
  '__proto__',
  'constructor',
  'toString',
  'length',
  'box',
  'checker',
  'dragon',
  'data:,',
  'blob:x',
];
const odd = [
  '../..',
  '\u0000',
  '\u202e\ud800',
  'ü🏮',
  'http://192.168.0.1/',
  'model.glb',
  'model.glb/mesh-1',
  'x'.repeat(5000),
];

/** A random value that a reader is unlikely to expect. */
export function hostileValue(random: FuzzRandom): unknown {
  switch (random.below(8)) {
    case 0:
      return null;
    case 1:
      return random.once(2);
    case 2:
      return [];
    case 3:
      return {};
    case 4:
      return nested(random.of([1, 3, 40, 2000]), random.once(2));
    case 5:
      return random.of(random.once(2) ? texts : odd);
    case 6:
      return [0, 1, 2].map(() => random.of(numbers));
    default:
      return random.of(numbers);
  }
}

/** A key that a file should not have. */
export const hostileKey = (random: FuzzRandom): string => random.of([...texts, 'values', 'parent', 'x'.repeat(500)]);

type Holder = Record<string, unknown>;

/** Every list and object in a value, itself included. */
function holdersIn(value: unknown): Holder[] {
  const holders: Holder[] = [];
  const left = [value];
  while (left.length > 0) {
    const each = left.pop();
    if (typeof each !== 'object' || each === null) continue;
    holders.push(each as Holder);
    left.push(...Object.values(each).slice(0, 200));
  }
  return holders;
}

/** Sets an own entry, whatever its name. */
const put = (holder: Holder, key: string, value: unknown): void => {
  Object.defineProperty(holder, key, { value, enumerable: true, configurable: true, writable: true });
};

/** JSON text of a value that is nested deeper than the stack is: JSON.stringify calls itself. */
function deepText(value: unknown): string {
  const parts: string[] = [];
  /** Parts still to be written, the next one last: text as it is, values in lists of one. */
  const left: (string | readonly [unknown])[] = [[value]];
  while (left.length > 0) {
    const next = left.pop()!;
    if (typeof next === 'string') {
      parts.push(next);
      continue;
    }
    const [each] = next;
    if (typeof each !== 'object' || each === null) {
      parts.push(JSON.stringify(each));
      continue;
    }
    const isList = Array.isArray(each);
    left.push(isList ? ']' : '}');
    const entries = Object.entries(each);
    for (let i = entries.length - 1; i >= 0; i--) {
      const [key, member] = entries[i];
      left.push([member], `${i > 0 ? ',' : ''}${isList ? '' : `${JSON.stringify(key)}:`}`);
    }
    left.push(isList ? '[' : '{');
  }
  return parts.join('');
}

/** Result of `run`, or of `deep` when `run` overflows the stack, whose size differs between threads. */
function orDeep<T>(run: () => T, deep: () => T): T {
  try {
    return run();
  } catch (error) {
    if (error instanceof RangeError) return deep();
    throw error;
  }
}

const jsonOf = (value: unknown): string =>
  orDeep(
    () => JSON.stringify(value),
    () => deepText(value),
  );

const copyOf = <T>(value: T): T =>
  orDeep(
    () => structuredClone(value),
    () => JSON.parse(deepText(value)) as T,
  );

/** Mutates a JSON value in a few places: entries replaced, removed, doubled, moved, added. */
export function mutate(value: unknown, random: FuzzRandom, changes = 1 + random.below(4)): void {
  for (let n = 0; n < changes; n++) {
    const holders = holdersIn(value);
    const holder = random.of(holders);
    const keys = Object.keys(holder);
    const key = keys.length > 0 ? random.of(keys) : Array.isArray(holder) ? '0' : hostileKey(random);
    const kind = random.below(6);
    if (kind === 0 && Array.isArray(holder)) holder.splice(random.below(holder.length + 1), 1);
    else if (kind === 0) delete holder[key];
    else if (kind === 1 && Array.isArray(holder)) holder.push(...copyOf(holder).slice(0, 20));
    else if (kind === 2) put(holder, key, copyOf(random.of(holders)));
    else if (kind === 3 && !Array.isArray(holder)) put(holder, hostileKey(random), hostileValue(random));
    else put(holder, key, hostileValue(random));
  }
}

/** JSON text with numbers that are infinite. */
export const textOf = (value: unknown): string => jsonOf(value).replaceAll(JSON.stringify(INFINITE), '1e999');

/** Mutates bytes: some replaced, removed or doubled, or the end cut off. */
export function mutateBytes(bytes: Uint8Array, random: FuzzRandom): Uint8Array<ArrayBuffer> {
  let list = [...bytes];
  for (let n = random.below(4); n >= 0 && list.length > 0; n--) {
    const at = random.below(list.length);
    const kind = random.below(5);
    if (kind === 0) list[at] = random.below(256);
    else if (kind === 1) list.splice(at, 1 + random.below(8));
    else if (kind === 2) list.splice(at, 0, ...list.slice(at, at + random.below(64)));
    else if (kind === 3) for (let i = at; i < Math.min(at + 4, list.length); i++) list[i] = random.of([0, 255, 127]);
    else if (random.once(3)) list = list.slice(0, at);
  }
  return new Uint8Array(list);
}
