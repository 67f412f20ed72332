import { parseAst } from 'vite';

/** @typedef {{ type: string, start: number, end: number, [key: string]: unknown }} Node */

const COUNT = '$farolSteps.count++';
const LOOPS = new Set(['ForStatement', 'ForInStatement', 'ForOfStatement', 'WhileStatement', 'DoWhileStatement']);
const FUNCTIONS = new Set(['FunctionDeclaration', 'FunctionExpression', 'ArrowFunctionExpression']);

/**
 * JavaScript that counts its steps in `$farolSteps.count`, on the same lines: one for each call of a function and each pass
 * of a loop.
 *
 * @param {string} code
 * @returns {string}
 */
export function withSteps(code) {
  /** @type {[at: number, text: string][]} */
  const additions = [];
  walk(/** @type {Node} */ (/** @type {unknown} */ (parseAst(code))), ({ type, body }) => {
    if (!LOOPS.has(type) && !FUNCTIONS.has(type)) return;
    const { type: kind, start, end } = /** @type {Node} */ (body);
    if (kind === 'BlockStatement') additions.push([start + 1, `${COUNT};`]);
    else if (FUNCTIONS.has(type)) additions.push([start, `(${COUNT},`], [end, ')']);
    else additions.push([start, `{${COUNT};`], [end, '}']);
  });
  let text = '';
  let last = 0;
  for (const [at, added] of additions.toSorted(([a], [b]) => a - b)) {
    text += code.slice(last, at) + added;
    last = at;
  }
  return text + code.slice(last);
}

/** @param {unknown} value - a node, a list of them, or anything else @param {(node: Node) => void} visit */
function walk(value, visit) {
  if (typeof value !== 'object' || value === null) return;
  if ('type' in value) visit(/** @type {Node} */ (value));
  for (const inner of Object.values(value)) walk(inner, visit);
}

/**
 * A Vite plugin that has the sources of this repository count their steps, for `workOf`: see {@link withSteps}.
 *
 * @returns {import('vite').Plugin}
 */
export const countSteps = () => ({
  name: 'farol-count-steps',
  enforce: 'post',
  transform: (code, id) =>
    /\/(packages|apps)\/(?!tools\/)[^?]*\.tsx?$/.test(id) && !id.endsWith('.test.ts')
      ? { code: withSteps(code), map: null }
      : null,
});
