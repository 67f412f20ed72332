import { parseSync } from 'vite';

const TEXT_FIELD = /<input\b|<textarea\b|HTMLInputElement|element\('(input|textarea)'/;
const KEYS = ['Enter', 'Escape'];

/**
 * Functions of a file with text fields that look for Enter or Escape without asking `isComposing` of @farol/editing, so
 * that an input method's Enter and Escape count as well.
 *
 * @param {string} path @param {string} source @returns {string[]} one line for each: file and line of the comparison
 */
export function uncheckedKeys(path, source) {
  if (!TEXT_FIELD.test(source) || !KEYS.some((key) => source.includes(`'${key}'`))) return [];
  /** @type {Set<number>} */
  const found = new Set();
  /** @param {any} node @param {{ start: number, end: number } | null} around - the innermost function */
  const visit = (node, around) => {
    if (Array.isArray(node)) for (const each of node) visit(each, around);
    if (!node || typeof node.type !== 'string') return;
    const inner = /Function/.test(node.type) ? node : around;
    const isComparison = node.type === 'BinaryExpression' && [node.left, node.right].some(isKey);
    if (isComparison && !(inner && source.slice(inner.start, inner.end).includes('isComposing('))) {
      found.add(source.slice(0, node.start).split('\n').length);
    }
    for (const child of Object.values(node)) if (child && typeof child === 'object') visit(child, inner);
  };
  visit(parseSync(path, source).program.body, null);
  return [...found].map((line) => `${path}:${line}`);
}

/** @param {any} node */
const isKey = (node) => node.type === 'Literal' && KEYS.includes(node.value);
