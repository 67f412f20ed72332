import { parseSync } from 'vite';

/** A node of oxc's tree. @typedef {import('./declarations.mjs').Node} Node */

/** A statement's place: the list that it is in, and where. @typedef {{ list: Node[], index: number }} Place */

/**
 * Code that uses an export.
 *
 * @typedef {object} Excerpt
 * @property {string} code - with the imports that it needs
 * @property {string} language - `ts` or `tsx`
 * @property {number} line - of its file, from 1
 * @property {number} cost - lines, and what a reader misses; the least is shown
 */

/** A name that a file imports. @typedef {{ specifier: string, imported: string }} Import */

/** Lines that an excerpt may have, and that a class in it may have before it is cut. */
const MOST_LINES = 16;
const MOST_OF_CLASS = 40;

/** Penalties of an excerpt (lines): for a name that it does not declare, a use that is no call, a check that is not shortened. */
const UNSHOWN = 4;
const NOT_CALLED = 2;
const CHECK = 6;

/**
 * The best excerpt of a file for each name of ours that it imports: the statement around a use, and the declarations before
 * it that it needs.
 *
 * @param {string} path - tells TypeScript from TSX
 * @param {string} source
 * @param {(found: Import) => Import | null} publicName - how a page imports it; null for names that pages cannot
 * @param {boolean} isWholeAlone - whether excerpts must declare or import all that they name
 * @returns {Map<string, Excerpt>} by `specifier name`, as pages import it
 */
export function excerptsOf(path, source, publicName, isWholeAlone) {
  const { program, comments } = parseSync(path, source);
  const file = new ExcerptFile(source, comments, program, publicName);
  const language = path.endsWith('x') ? 'tsx' : 'ts';
  /** @type {Map<string, Excerpt>} */
  const best = new Map();
  for (const { name, places, isCalled } of file.uses) {
    const found = file.excerpt(places, isWholeAlone);
    if (found === null) continue;
    const { specifier, imported } = /** @type {Import} */ (file.imports.get(name));
    const key = `${specifier} ${imported}`;
    const cost = found.cost + (isCalled ? 0 : NOT_CALLED);
    if (cost < (best.get(key)?.cost ?? Infinity)) best.set(key, { ...found, cost, language });
  }
  return best;
}

class ExcerptFile {
  /** Names that pages import too, by the file's name. @type {Map<string, Import & { isType: boolean }>} */
  imports = new Map();
  /** Names that pages cannot import. @type {Set<string>} */
  unshown = new Set();
  /** @type {{ name: string, places: Place[], isCalled: boolean }[]} */
  uses = [];

  /**
   * @param {string} source
   * @param {import('vite').ParseResult['comments']} comments
   * @param {Node} program
   * @param {(found: Import) => Import | null} publicName
   */
  constructor(source, comments, program, publicName) {
    this.source = source;
    this.comments = comments;
    for (const node of program.body)
      if (node.type === 'ImportDeclaration')
        for (const { imported, local, importKind } of node.specifiers) {
          const found = publicName({ specifier: node.source.value, imported: imported?.name ?? '' });
          const isType = node.importKind === 'type' || importKind === 'type';
          if (found) this.imports.set(local.name, { ...found, isType });
          else this.unshown.add(local.name);
        }
    this.find(program, null, []);
  }

  /** Finds uses of imported names below a node. @param {Node} node @param {Node} parent @param {Place[]} places */
  find(node, parent, places) {
    if (node.type === 'ImportDeclaration') return;
    const name = nameOf(node, parent);
    const found = name !== null && this.imports.get(name);
    if (found && found.specifier.startsWith('@farol/') && places.length > 0) {
      const isCalled = parent.callee === node || parent.superClass === node || parent.type === 'JSXOpeningElement';
      this.uses.push({ name, places, isCalled: isCalled || parent.type.startsWith('TS') });
    }
    for (const [key, child] of Object.entries(node)) {
      if (child === null || typeof child !== 'object') continue;
      if (!Array.isArray(child)) {
        if (child.type) this.find(child, node, places);
        continue;
      }
      const isList = isStatements(node, key);
      for (const [index, each] of child.entries())
        if (each?.type) this.find(each, node, isList ? [...places, { list: child, index }] : places);
    }
  }

  /**
   * @param {Place[]} places - from the file's to the innermost
   * @param {boolean} isWholeAlone
   * @returns {Omit<Excerpt, 'language'> | null}
   */
  excerpt(places, isWholeAlone) {
    const { list, index } = places[places.length - 1];
    const statement = list[index];
    let lines = this.lineCount(statement);
    let isCut = false;
    const { type } = statement.declaration ?? statement;
    if (lines > (type === 'ClassDeclaration' ? MOST_OF_CLASS : MOST_LINES)) {
      if (!/Class|Function/.test(type)) return null;
      isCut = true;
    }
    const shown = new Set([statement]);
    const needed = namesIn(statement);
    // what is made is used in the next lines
    const made = statement.type === 'VariableDeclaration' ? declaredBy(statement) : [];
    let following = 0;
    for (const each of made.length > 0 ? list.slice(index + 1, index + 4) : []) {
      const more = this.lineCount(each);
      const names = namesIn(each);
      const goesOn = /Expression|Variable/.test(each.type) && more <= 3 && lines + more <= MOST_LINES;
      if (!goesOn || !made.some((name) => names.has(name))) break;
      shown.add(each);
      lines += more;
      following += more;
      for (const name of names) needed.add(name);
    }
    // an excerpt that goes on to use the thing tells more than a shorter one
    let cost = (isCut ? 8 : 0) - 2 * following;
    for (const { list, index } of places.toReversed())
      for (const each of list.slice(0, index).toReversed()) {
        if (each.type === 'ImportDeclaration') continue;
        const declared = declaredBy(each);
        if (!declared.some((name) => needed.has(name))) continue;
        const more = this.lineCount(each);
        if (!isCut && lines + more <= MOST_LINES) {
          shown.add(each);
          lines += more;
          for (const name of namesIn(each)) needed.add(name);
        } else cost += UNSHOWN;
      }
    const texts = [...shown].toSorted((a, b) => a.start - b.start).map((each) => this.checked(each));
    // the checks that are shown as values name no `expect`
    if (texts.every((text) => !/\bexpect\(/.test(text))) needed.delete('expect');
    else cost += CHECK;
    const bound = new Set([...shown].flatMap((each) => [...declaredBy(each), ...boundIn(each)]));
    const isWhole = !isCut && [...needed].every((name) => bound.has(name) || this.imports.has(name) || isGlobal(name));
    if (isWholeAlone && !isWhole) return null;
    cost += UNSHOWN * [...needed].filter((name) => this.unshown.has(name)).length;
    const code = [...this.importLines(needed), ...(isCut ? [this.cut(texts.join('\n'))] : texts)].join('\n');
    return {
      code,
      line: this.source.slice(0, statement.start).split('\n').length,
      cost: cost + Math.min(lines, MOST_LINES),
    };
  }

  /** Import declarations of names. @param {Set<string>} names */
  importLines(names) {
    /** @type {Map<string, string[]>} */
    const bySpecifier = new Map();
    for (const [local, { specifier, imported, isType }] of this.imports) {
      if (!names.has(local)) continue;
      const text = imported === '' ? `* as ${local}` : imported === local ? local : `${imported} as ${local}`;
      bySpecifier.set(specifier, [...(bySpecifier.get(specifier) ?? []), isType ? `type ${text}` : text]);
    }
    return [...bySpecifier].map(([specifier, all]) => {
      const named = all.every((each) => !each.includes('*'));
      const list = all.toSorted((a, b) => a.replace('type ', '').localeCompare(b.replace('type ', '')));
      return `import ${named ? `{ ${list.join(', ')} }` : all.join(', ')} from '${specifier}';`;
    });
  }

  /** A check of a test as its value in a comment. @param {Node} statement */
  checked(statement) {
    const whole = statement.type === 'ExpressionStatement' ? statement.expression : null;
    const call = whole?.type === 'AwaitExpression' ? whole.argument : whole;
    const object = call?.type === 'CallExpression' && call.callee.object;
    const isAwaited = whole !== call && object?.property?.name === 'rejects';
    const expected = isAwaited ? object.object : object;
    if (!expected || expected.callee?.name !== 'expect' || call.arguments.length > 1) return this.text(statement);
    const matcher = call.callee.property.name;
    const [actual] = expected.arguments;
    const value = call.arguments[0] ? this.text(call.arguments[0]) : '';
    const result = {
      ...{ toBe: value, toEqual: value, toStrictEqual: value, toBeCloseTo: `about ${value}`, toMatchObject: value },
      ...{ toContain: `contains ${value}`, toBeGreaterThan: `above ${value}` },
      ...{ toBeNull: 'null', toBeUndefined: 'undefined', toThrow: `throws ${value || 'an error'}` },
    }[/** @type {string} */ (matcher)];
    if (result === undefined || result.includes('\n')) return this.text(statement);
    return `${isAwaited ? 'await ' : ''}${this.text(matcher === 'toThrow' && actual.body ? actual.body : actual)}; // ${result}`;
  }

  /** Shortens the code of a long class or function to its first members or statements. @param {string} text */
  cut(text) {
    const lines = text.split('\n');
    const end = lines.findLastIndex((line, i) => i < MOST_LINES - 2 && /^ {2}\S|^$/.test(line));
    return [...lines.slice(0, Math.max(end, 1)), '  // …', '}'].join('\n');
  }

  /** A node's code, at the margin, with the comment at its end. @param {Node} node */
  text(node) {
    const lineStart = this.source.lastIndexOf('\n', node.start - 1) + 1;
    const margin = /^ */.exec(this.source.slice(lineStart))?.[0] ?? '';
    const lineEnd = this.source.indexOf('\n', node.end);
    const after = this.comments.find(({ start }) => start >= node.end && start < lineEnd);
    const isBeside = after && /^[;,\s]*$/.test(this.source.slice(node.end, after.start));
    const text =
      this.source.slice(node.start, node.end) + (isBeside ? ` ${this.source.slice(after.start, after.end)}` : '');
    return text.replaceAll(`\n${margin}`, '\n');
  }

  /** @param {Node} node */
  lineCount(node) {
    return this.source.slice(node.start, node.end).split('\n').length;
  }
}

/** Whether a node's property is a list of statements. @param {Node} node @param {string} key */
const isStatements = (node, key) =>
  (key === 'body' && ['Program', 'BlockStatement', 'StaticBlock'].includes(node.type)) || key === 'consequent';

/** Name that an identifier refers by; null for names of properties. @param {Node} node @param {Node} parent */
function nameOf(node, parent) {
  if (node.type !== 'Identifier' && node.type !== 'JSXIdentifier') return null;
  const isMember = (parent?.property === node || (parent?.key === node && !parent.shorthand)) && !parent.computed;
  return isMember || parent?.type === 'JSXAttribute' ? null : node.name;
}

/** Calls for each node below one, and it. @param {Node} root @param {(node: Node, parent: Node) => void} call */
function walk(root, call) {
  /** @type {(node: Node, parent: Node) => void} */
  const visit = (node, parent) => {
    call(node, parent);
    for (const child of Object.values(node)) {
      if (child === null || typeof child !== 'object') continue;
      for (const each of Array.isArray(child) ? child : [child]) if (each?.type) visit(each, node);
    }
  };
  visit(root, null);
}

/** @param {Node} root @returns {Set<string>} names that a node refers to */
function namesIn(root) {
  /** @type {Set<string>} */
  const names = new Set();
  walk(root, (node, parent) => {
    const name = nameOf(node, parent);
    if (name !== null) names.add(name);
  });
  return names;
}

/** Names that a statement declares. @param {Node} statement @returns {string[]} */
function declaredBy(statement) {
  const node = statement.declaration ?? statement;
  if (node.type === 'VariableDeclaration')
    return node.declarations.flatMap((/** @type {Node} */ { id }) =>
      id.type === 'Identifier' ? [id.name] : [...namesIn(id)],
    );
  return node.id?.name ? [node.id.name] : [];
}

/** Names that a node binds inside: parameters, variables. @param {Node} root @returns {Set<string>} */
function boundIn(root) {
  /** @type {Set<string>} */
  const names = new Set();
  walk(root, (node) => {
    const bound = [...(node.params ?? []), ...(node.param ? [node.param] : []), ...(node.id ? [node.id] : [])];
    for (const each of bound) for (const name of namesIn(each)) names.add(name);
  });
  return names;
}

/** Names of every page and of TypeScript itself. @param {string} name */
const isGlobal = (name) =>
  name in globalThis ||
  /^(const|undefined|document|window|addEventListener|innerWidth|innerHeight|devicePixelRatio)$/.test(name) ||
  /^(Readonly|Partial|Required|Record|ReturnType|Parameters|HTML\w*Element|ReadonlyArray)$/.test(name);
