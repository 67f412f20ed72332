import { parseSync } from 'vite';
import { docblockBefore, parseDocblock } from './docblock.mjs';

/** A node of oxc's tree. @typedef {any} Node */

/** @typedef {import('./docblock.mjs').Docblock} Docblock */

/** A member of a class or an interface. @typedef {{ name: string, signature: string, doc: Docblock }} ApiMember */

/**
 * A declaration, as its file has it.
 *
 * @typedef {object} Declaration
 * @property {'class' | 'function' | 'constant' | 'interface' | 'type'} kind
 * @property {string[]} signatures - code, one of each overload
 * @property {Docblock} doc
 * @property {ApiMember[]} members
 * @property {number} line - from 1
 * @property {Set<string>} mentions - names of types and classes in its signatures and its members' ones
 */

/** Characters of a value that a signature shows. */
const SHORT = 70;

/** @type {Readonly<Record<string, Declaration['kind']>>} */
const kinds = {
  ClassDeclaration: 'class',
  FunctionDeclaration: 'function',
  TSDeclareFunction: 'function',
  TSInterfaceDeclaration: 'interface',
  TSTypeAliasDeclaration: 'type',
};

/**
 * Declarations of the first level of a file.
 *
 * @param {string} path
 * @param {string} source
 * @returns {Map<string, Declaration>} by name; a constant and a type of one name are one, the constant's
 */
export function declarationsOf(path, source) {
  const { program, comments } = parseSync(path, source);
  const code = new Code(source, comments);
  /** @type {Map<string, Declaration>} */
  const found = new Map();
  for (const statement of /** @type {Node[]} */ (program.body)) {
    const node = statement.declaration ?? statement;
    const nodes = node.type === 'VariableDeclaration' ? node.declarations : kinds[node.type] ? [node] : [];
    for (const each of nodes) {
      if (each.id?.type !== 'Identifier') continue;
      const { name } = each.id;
      const next = code.declaration(each, statement.start);
      const before = found.get(name);
      if (before === undefined) found.set(name, next);
      else merge(before, next);
    }
  }
  return found;
}

/** Adds an overload, or a type of the same name. @param {Declaration} to @param {Declaration} from */
function merge(to, from) {
  to.signatures.push(...from.signatures);
  to.members.push(...from.members);
  if (to.doc.text === '') to.doc = from.doc;
  for (const name of from.mentions) to.mentions.add(name);
}

class Code {
  /** @param {string} source @param {import('vite').ParseResult['comments']} comments */
  constructor(source, comments) {
    this.source = source;
    this.comments = comments;
  }

  /** @param {Node} node @param {number} start - of the whole statement @returns {Declaration} */
  declaration(node, start) {
    const kind = kinds[node.type] ?? (isFunction(node.init) ? 'function' : 'constant');
    const members = this.members(node);
    // an overloaded function's last declaration is of its body alone
    const signatures = [this.signature(node, kind)];
    return {
      kind,
      signatures,
      doc: docblockBefore(this.comments, this.source, start),
      members,
      line: this.source.slice(0, node.start).split('\n').length,
      mentions: new Set([...signatures, ...members.map(({ signature }) => signature)].join(' ').match(/\b[A-Z]\w*/g)),
    };
  }

  /** @param {Node} node @param {Declaration['kind']} kind */
  signature(node, kind) {
    if (kind === 'class' || kind === 'interface') {
      const table = tableOf(node);
      if (!table) return this.text(node.start, node.body.start);
      return `${this.text(node.start, table.start)}{ … }${this.text(table.end, node.body.start)}`;
    }
    if (node.type === 'TSTypeAliasDeclaration') {
      const literal = node.typeAnnotation.type === 'TSTypeLiteral';
      return this.lines(node.start, literal ? node.typeAnnotation.start : node.end).replace(/ =$/, '');
    }
    if (node.type !== 'VariableDeclarator') return this.text(node.start, node.body?.start ?? node.end);
    return `const ${this.valued(node, node.init)}`;
  }

  /** Name, type and value of a constant; a function without its body. @param {Node} node @param {Node} value */
  valued(node, value) {
    if (!value) return this.text(node.start, node.end);
    const typed = (node.id ?? node).typeAnnotation ?? node.typeAnnotation;
    if (isFunction(value) && !typed) return this.text(node.start, value.body.start).replace(/ ?=>$/, '');
    const whole = this.text(node.start, node.end);
    const inner = value.type === 'TSSatisfiesExpression' || value.type === 'TSAsExpression' ? value.expression : value;
    const isShort = whole.length <= SHORT && !isFunction(inner) && !/^(private|protected)/.test(whole);
    if (isShort) return whole;
    const type = !typed && value.type === 'NewExpression' ? `: ${this.text(value.callee.start, value.callee.end)}` : '';
    return this.text(node.start, value.start).replace(/\s*=$/, '') + type;
  }

  /** @param {Node} node @returns {ApiMember[]} */
  members(node) {
    /** @type {Node[]} */
    const nodes = node.body?.body ?? node.typeAnnotation?.members ?? [];
    if (node.type === 'FunctionDeclaration' || node.type === 'TSDeclareFunction') return [];
    const fields = this.fields(tableOf(node)?.properties ?? []);
    const setters = new Set(nodes.filter(({ kind }) => kind === 'set').map(({ key }) => key.name));
    const members = nodes.flatMap((each) => {
      const fields = each.kind === 'constructor' ? this.parameterProperties(each) : [];
      const name = each.key ? this.text(each.key.start, each.key.end) : '';
      const doc = docblockBefore(this.comments, this.source, each.start);
      const isHidden =
        each.type === 'StaticBlock' ||
        each.accessibility === 'private' ||
        name.startsWith('#') ||
        doc.isInternal ||
        (each.override && doc.text === '') ||
        (each.kind === 'set' && nodes.some(({ kind, key }) => kind === 'get' && key.name === name)) ||
        (each.kind === 'constructor' && each.value.params.length === 0);
      if (isHidden) return fields;
      return [{ name, signature: this.memberSignature(each, name, setters.has(name)), doc }, ...fields];
    });
    return [...fields, ...members];
  }

  /** Fields that a class declares by a table, with their help as text. @param {Node[]} properties @returns {ApiMember[]} */
  fields(properties) {
    return properties
      .filter(({ value }) => value?.type === 'CallExpression')
      .map(({ key, value }) => {
        const options = value.arguments.find((/** @type {Node} */ { type }) => type === 'ObjectExpression');
        const told = /^(help|label|optionLabels|group)$/;
        /** @type {Node[]} */
        const all = (options?.properties ?? []).filter((/** @type {Node} */ each) => each.type === 'Property');
        const shown = all.filter((each) => !told.test(each.key.name)).map((each) => this.text(each.start, each.end));
        const help = all.find((each) => each.key.name === 'help')?.value;
        const first = value.arguments.filter((/** @type {Node} */ each) => each !== options);
        const values = first.map((/** @type {Node} */ each) => this.text(each.start, each.end));
        const list = [...values, ...(shown.length > 0 ? [`{ ${shown.join(', ')} }`] : [])].join(', ');
        const text = help?.type === 'Literal' ? help.value : '';
        return {
          name: key.name,
          signature: `${key.name}: ${this.text(value.callee.start, value.callee.end)}(${list})`,
          doc: { ...parseDocblock(''), text },
        };
      });
  }

  /** Parameters of a constructor that are properties, and seen from outside. @param {Node} node @returns {ApiMember[]} */
  parameterProperties(node) {
    return node.value.params
      .filter(
        (/** @type {Node} */ { type, accessibility }) => type === 'TSParameterProperty' && accessibility !== 'private',
      )
      .map((/** @type {Node} */ each) => ({
        name: (each.parameter.left ?? each.parameter).name,
        signature: this.text(each.start, each.end),
        doc: docblockBefore(this.comments, this.source, each.start),
      }));
  }

  /** @param {Node} node @param {string} name @param {boolean} isSet - whether it has a setter */
  memberSignature(node, name, isSet) {
    const { value } = node;
    if (node.kind === 'get' || node.kind === 'set') {
      const type = node.kind === 'get' ? value.returnType : value.params[0]?.typeAnnotation;
      const readonly = node.kind === 'get' && !isSet ? 'readonly ' : '';
      return `${node.static ? 'static ' : ''}${readonly}${name}${type ? this.text(type.start, type.end) : ''}`;
    }
    if (node.type === 'PropertyDefinition') return this.valued(node, value).replace(/^(override|declare) /, '');
    return this.text(node.start, value?.body?.start ?? node.end)
      .replace(/\b(private|protected|readonly) (?=[\w ]+[:?])/g, '')
      .replace(/^(override|async) /, '')
      .replace(/\b_(?=\w+[:?])/g, '');
  }

  /** Code in one line, without comments. @param {number} start @param {number} end */
  text(start, end) {
    return this.lines(start, end)
      .replace(/\s+/g, ' ')
      .replace(/([([{]) (?=.)/g, (m, b) => (b === '{' ? m : b))
      .replace(/,? ([)\]])/g, '$1')
      .trim();
  }

  /** Code without comments. @param {number} start @param {number} end */
  lines(start, end) {
    let text = '';
    let at = start;
    for (const comment of this.comments)
      if (comment.start >= at && comment.end <= end) {
        text += this.source.slice(at, comment.start).replace(/[ \t]+$/, '');
        at = comment.end;
      }
    return (text + this.source.slice(at, end))
      .replace(/\n\s*\n/g, '\n')
      .replace(/;$/, '')
      .trim();
  }
}

/** @param {Node} node */
const isFunction = (node) => node?.type === 'ArrowFunctionExpression' || node?.type === 'FunctionExpression';

/** Table of fields that a class extends, as in `extends component({ … })`. @param {Node} node @returns {Node} */
const tableOf = (node) =>
  node.superClass?.type === 'CallExpression' &&
  node.superClass.arguments.find((/** @type {Node} */ { type }) => type === 'ObjectExpression');
