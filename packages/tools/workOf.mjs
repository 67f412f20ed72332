/**
 * Steps so far of code that the plugin `countSteps` has changed.
 *
 * @type {{ $farolSteps: { count: number } }}
 */
const counter = /** @type {any} */ (globalThis);
counter.$farolSteps ??= { count: 0 };

/** Elements that built-in functions went through so far, while `workOf` runs something. */
let elements = 0;

/** Elements that a built-in function copies or compares in about the time of one step of ours. */
const ELEMENTS = 64;

/** @param {unknown} value @returns {number} elements, or letters */
function sizeOf(value) {
  if (typeof value === 'string') return value.length;
  if (typeof value !== 'object' || value === null) return 0;
  if (value instanceof Map || value instanceof Set) return value.size;
  return 'length' in value ? Number(value.length) : 0;
}

/** @typedef {(target: unknown, args: unknown[], result: unknown) => number} Size elements of one call */

/** @type {Size} */
const ofTarget = sizeOf;
/** @type {Size} */
const ofResult = (_target, _args, result) => sizeOf(result);
/** @type {Size} */
const ofArguments = (_target, args) => args.map(sizeOf).reduce((sum, size) => sum + size, 0);
/** @type {Size} */
const ofSearch = (target, [, from = 0], result) =>
  (typeof result === 'number' && result >= 0 ? result + 1 : sizeOf(target)) - Number(from);
/** Elements that were taken out, and those after them, which move. @type {Size} */
const ofSplice = (target, [start = 0], result) =>
  Number(start) < 0 ? -Number(start) : sizeOf(target) + sizeOf(result) - Number(start);

/** @param {Iterable<unknown>} list @returns {Row} */
function iteration(list) {
  return [Object.getPrototypeOf(list[Symbol.iterator]()), ['next'], () => 1];
}

/** @typedef {[owner: object, names: PropertyKey[], size: Size]} Row */

/** Built-in functions that go through many elements in one call. @type {Row[]} */
const builtIns = [
  [Array.prototype, ['indexOf', 'includes'], ofSearch],
  [Array.prototype, ['splice'], ofSplice],
  [Array.prototype, ['slice', 'concat', 'flat', 'toSorted', 'toSpliced', 'toReversed', 'with'], ofResult],
  [Array.prototype, ['shift', 'unshift', 'join', 'reverse', 'sort', 'fill'], ofTarget],
  [Object.getPrototypeOf(Uint8Array.prototype), ['indexOf', 'includes'], ofSearch],
  [Object.getPrototypeOf(Uint8Array.prototype), ['slice'], ofResult],
  [Object.getPrototypeOf(Uint8Array.prototype), ['set'], ofArguments],
  [Object.getPrototypeOf(Uint8Array.prototype), ['fill', 'sort'], ofTarget],
  [String.prototype, ['indexOf', 'includes'], ofSearch],
  [String.prototype, ['replaceAll', 'repeat'], ofResult],
  [String.prototype, ['split'], ofTarget],
  // loops, spreads and constructors go through lists, Maps and Sets by these
  ...[[], new Map(), new Set()].map(iteration),
  [Object, ['keys', 'values', 'entries'], ofResult],
  [JSON, ['stringify'], ofResult],
  [JSON, ['parse'], ofArguments],
];

/** Makes built-in functions count their steps. @returns {() => void} puts them back */
function countBuiltIns() {
  /** @type {(() => void)[]} */
  const undo = [];
  for (const [owner, names, size] of builtIns) {
    for (const name of names) {
      const described = Object.getOwnPropertyDescriptor(owner, name);
      if (!described) continue;
      const { value } = described;
      /** @this {unknown} @param {unknown[]} args */
      const counting = function (...args) {
        const result = Reflect.apply(value, this, args);
        elements += size(this, args, result);
        return result;
      };
      Object.defineProperty(owner, name, { ...described, value: counting });
      undo.push(() => void Object.defineProperty(owner, name, described));
    }
  }
  return () => {
    for (let i = 0; i < undo.length; i++) undo[i]();
  };
}

/**
 * Counts the work of something, as a number that is equal on every machine: calls of functions and passes of loops in the
 * sources of this repository, and a step for each 64 elements that built-in functions go through. Only in files `*.work.test.ts`, whose sources
 * count. Regular expressions, three and other packages are no part of it.
 *
 * @param {() => unknown} run - may be asynchronous
 * @returns {Promise<number>} steps
 */
export async function workOf(run) {
  const undo = countBuiltIns();
  counter.$farolSteps.count = 0;
  elements = 0;
  try {
    await run();
    const { count } = counter.$farolSteps;
    if (count === 0) throw new Error('No work was counted: the test must be in a file *.work.test.ts.');
    return count + elements / ELEMENTS;
  } finally {
    undo();
  }
}

/**
 * Ratio of the work for `4 * count` to the work for `count`: 4 where work grows linearly, 16 where it grows with the
 * square.
 *
 * @param {number} count
 * @param {(count: number) => (() => unknown) | Promise<() => unknown>} prepare - does what is not counted; returns the
 *   work, which may be asynchronous
 */
export async function growthOf(count, prepare) {
  const few = await workOf(await prepare(count));
  return (await workOf(await prepare(4 * count))) / few;
}
