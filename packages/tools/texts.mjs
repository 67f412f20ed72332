import { parseSync } from 'vite';

/** Attributes that the user reads or hears. */
const shownAttributes = new Set([
  ...['aria-label', 'aria-description', 'aria-roledescription', 'aria-valuetext', 'title', 'placeholder', 'alt'],
  ...['label', 'help', 'description', 'note', 'text', 'data-help'],
]);

/** Names and units that are the same in all languages. */
const sameInAll = /\b(Farol|three\.js|MIT|glTF|PSNR|SMAA|TAA|[CG]PU|FPS|ms|[kM]B|dB)\b/g;

const hasWords = (/** @type {string} */ text) => /\p{L}{2}/u.test(text.replaceAll(sameInAll, ''));

/**
 * The English texts that a file gives to `t()` and `tCount()` of @farol/editing, and what it shows without them.
 *
 * @param {string} path
 * @param {string} source
 * @returns {{ texts: string[], faults: string[] }} texts; and what is wrong, one line each
 */
export function textsOf(path, source) {
  /** @type {string[]} */
  const texts = [];
  /** @type {string[]} */
  const faults = [];
  const fault = (/** @type {any} */ node, /** @type {string} */ why) => {
    faults.push(`${path}:${source.slice(0, node.start).split('\n').length} ${why}`);
  };
  const untranslated = (/** @type {any} */ node) => {
    for (const text of [...literalsOf(node), ...piecesOf(node)])
      if (hasWords(text)) fault(node, `'${text.trim()}' is shown without t()`);
  };
  /** @param {any} node @param {boolean} isLate - whether a call evaluates it, not the beginning of the module */
  const visit = (node, isLate) => {
    if (Array.isArray(node)) {
      for (const each of node) visit(each, isLate);
      return;
    }
    if (typeof node?.type !== 'string') return;
    if (node.type === 'CallExpression' && ['t', 'tCount'].includes(node.callee.name)) {
      const found = node.arguments.slice(...(node.callee.name === 't' ? [0, 1] : [1, 3])).flatMap(literalsOf);
      texts.push(...found);
      if (found.length > 0 && !isLate) fault(node, `'${found[0]}' is looked up before there is a language`);
    } else if (node.type === 'CallExpression' && node.callee.name === 'countLabel') untranslated(node.arguments[0]);
    else if (node.type === 'JSXText' && hasWords(node.value))
      fault(node, `'${node.value.trim()}' is shown without t()`);
    else if (node.type === 'JSXAttribute' && shownAttributes.has(node.name.name))
      untranslated(node.value?.expression ?? node.value);
    else if (node.type === 'JSXElement' || node.type === 'JSXFragment')
      for (const { type, expression } of node.children) if (type === 'JSXExpressionContainer') untranslated(expression);
    const isCalled = isLate || /Function|MethodDefinition|PropertyDefinition/.test(node.type);
    for (const key of Object.keys(node)) if (key !== 'parent') visit(node[key], isCalled);
  };
  visit(parseSync(path, source).program, false);
  return { texts, faults };
}

/** The texts that an expression may be, as far as they stand in it. @param {any} node @returns {string[]} */
function literalsOf(node) {
  switch (node?.type) {
    case 'Literal':
      return typeof node.value === 'string' ? [node.value] : [];
    case 'TemplateLiteral':
      return node.expressions.length === 0 ? [node.quasis[0].value.cooked] : [];
    case 'ConditionalExpression':
      return [...literalsOf(node.consequent), ...literalsOf(node.alternate)];
    case 'LogicalExpression':
      return [...literalsOf(node.left), ...literalsOf(node.right)];
    case 'ParenthesizedExpression':
    case 'TSAsExpression':
      return literalsOf(node.expression);
    default:
      return [];
  }
}

/** Literal pieces of a template, around its values. @param {any} node @returns {string[]} */
function piecesOf(node) {
  if (node?.type === 'ConditionalExpression') return [...piecesOf(node.consequent), ...piecesOf(node.alternate)];
  if (node?.type === 'LogicalExpression') return [...piecesOf(node.left), ...piecesOf(node.right)];
  if (node?.type !== 'TemplateLiteral' || node.expressions.length === 0) return [];
  return node.quasis.map((/** @type {any} */ { value }) => value.cooked);
}

/**
 * The texts that a file gives to properties of some names, such as `help: 'Colour of the fog.'`.
 *
 * @param {string} path
 * @param {string} source
 * @param {...string} names - of the properties
 * @returns {string[]}
 */
export function propertyTexts(path, source, ...names) {
  /** @type {string[]} */
  const texts = [];
  /** @param {any} node */
  const visit = (node) => {
    if (Array.isArray(node)) node.forEach(visit);
    if (typeof node?.type !== 'string') return;
    if (node.type === 'Property' && names.includes(node.key.name)) texts.push(...literalsOf(node.value));
    for (const key of Object.keys(node)) if (key !== 'parent') visit(node[key]);
  };
  visit(parseSync(path, source).program);
  return texts;
}

/**
 * A file's objects of texts alone, as one: of `export const a = { 'One': 'Uno' }` { One: 'Uno' }.
 *
 * @param {string} path
 * @param {string} source
 * @returns {Record<string, string>}
 */
export function tableOf(path, source) {
  /** @type {Record<string, string>} */
  const table = {};
  /** @param {any} node */
  const visit = (node) => {
    if (Array.isArray(node)) node.forEach(visit);
    if (typeof node?.type !== 'string') return;
    if (node.type === 'Property' && typeof node.value.value === 'string')
      table[node.key.name ?? node.key.value] = node.value.value;
    for (const key of Object.keys(node)) if (key !== 'parent') visit(node[key]);
  };
  visit(parseSync(path, source).program);
  return table;
}
