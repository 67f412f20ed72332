import { parseSync } from 'vite';

/** @typedef {{ type: string, start: number, end: number, [key: string]: any }} Node */

/** @type {readonly [callee: RegExp, name: string][]} */
const CLOCKS = [
  [/(^|\.)performance\.now$/, 'performance.now'],
  [/(^|\.)Date\.now$/, 'Date.now'],
  [/^((window|globalThis|self)\.)?set(Timeout|Interval)$/, 'setTimeout'],
  [/\.waitForTimeout$/, 'waitForTimeout'],
  [/(^|\.)hrtime(\.bigint)?$/, 'hrtime'],
  [/(^|\.)cpuUsage$/, 'cpuUsage'],
];
const FRAMES = 'counted frames';
/** Sources without any of these are not parsed. */
const ANY = /performance|Date|set(Timeout|Interval)|waitForTimeout|hrtime|cpuUsage|requestAnimationFrame/;

/**
 * Uses of time in the source of a test: clocks, and frames of a page that are counted to wait for something. Fake
 * clocks do not count, nor does a loop that asks in each frame whether something is there. Files `*.verify.test.ts` and
 * `*.long.ts`, and tests with `@verify` or `@long` in their titles, may use time.
 *
 * @param {string} path
 * @param {string} source - TypeScript
 * @returns {string[]} a line each: the path, the number of the line, and what is used there
 */
export function clocksIn(path, source) {
  if (/\.(verify\.test|long)\.tsx?$/.test(path) || !ANY.test(source)) return [];
  const { program } = parseSync(path, source);
  const textOf = (/** @type {Node} */ { start, end }) => source.slice(start, end);
  /** Functions of the file that wait for a frame. @type {string[]} */
  const waiting = ['requestAnimationFrame'];
  /** @type {[at: number, name: string][]} */
  const found = [];
  const waits = (/** @type {Node} */ node) =>
    new RegExp(`\\bawait\\b[^;]*\\b(${waiting.join('|')})\\b`).test(textOf(node));

  /** @param {unknown} value - a node, a list of them, or anything else @param {string} within - text of the function around it */
  function visit(value, within) {
    if (typeof value !== 'object' || value === null) return;
    if (Array.isArray(value)) {
      value.forEach((each) => visit(each, within));
      return;
    }
    const node = /** @type {Node} */ (value);
    if (isOfVerify(node, textOf)) return;
    const name = typeof node.type === 'string' ? timeOf(node, within) : null;
    if (name) found.push([node.start, name]);
    const inner = /Function/.test(node.type) ? textOf(node) : within;
    for (const each of Object.values(node)) visit(each, inner);
  }

  /** @param {Node} node @param {string} within @returns {string | null} */
  function timeOf(node, within) {
    if (node.type === 'CallExpression') {
      const callee = textOf(node.callee);
      const isNested =
        callee.endsWith('requestAnimationFrame') && /requestAnimationFrame\(/.test(argumentsOf(node, textOf));
      return isNested ? FRAMES : (CLOCKS.find(([pattern]) => pattern.test(callee))?.[1] ?? null);
    }
    if (node.type === 'NewExpression') return textOf(node) === 'new Date()' ? 'new Date()' : null;
    if (node.type === 'ForStatement') return node.test && waits(node.body) ? FRAMES : null;
    if (node.type === 'BinaryExpression') {
      const isCount = [node.left, node.right].some(({ type }) => type === 'UpdateExpression');
      return isCount && within.includes('requestAnimationFrame(') ? FRAMES : null;
    }
    return null;
  }

  for (const [, name] of source.matchAll(
    /\bconst (\w+) = (?:async )?\([^)]*\) => new Promise\(requestAnimationFrame\)/g,
  ))
    waiting.push(name);
  visit(program, '');
  return found.map(([at, name]) => `${path}:${source.slice(0, at).split('\n').length} ${name}`);
}

/** @param {Node} call @param {(node: Node) => string} textOf */
const argumentsOf = (call, textOf) => call.arguments.map(textOf).join();

/** Whether a node is a test, or a group of them, of verify alone. @param {Node} node @param {(node: Node) => string} textOf */
function isOfVerify(node, textOf) {
  if (node.type !== 'CallExpression' || !/^(test|it|describe)\b/.test(textOf(node.callee))) return false;
  const [title, details] = node.arguments;
  return [title, details].some((each) => each && !/Function/.test(each.type) && /@(verify|long)\b/.test(textOf(each)));
}
