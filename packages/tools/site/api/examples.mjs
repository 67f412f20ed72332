import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../../root.mjs';
import { filesEnding } from '../../sourceFiles.mjs';
import { excerptsOf } from './excerpts.mjs';

/** @typedef {import('./readApi.mjs').ApiExport} ApiExport */

/**
 * An example of an export: an excerpt of code that tests compile and run.
 *
 * @typedef {import('./excerpts.mjs').Excerpt & { path: string, of: string }} Example path: its file, from the
 *   repository's root; of: export that it uses: for a type, it may be one that takes or returns the type
 */

/** Cost that an excerpt has for coming from a unit test. */
const TEST = 30;

/** Code that tests run; the less it teaches readers, the higher its cost. @type {{ files: RegExp, cost: number }[]} */
const sources = [
  { files: /^e2e\/samples\/.*\.tsx?$/, cost: 0 },
  { files: /^(README|packages\/\w+\/(README|docs\/[\w-]+))\.md$/, cost: 0 },
  { files: /^packages\/create-farol\/templates\/.*\.tsx?$/, cost: 2 },
  { files: /^apps\/site\/live\/gallery\/.*\.tsx?$/, cost: 2 },
  { files: /^e2e\/pages\/authoring\/.*\.ts$/, cost: 3 },
  { files: /^packages\/scenes\/src\/(?!.*\.test\.).*\.ts$/, cost: 8 },
  { files: /^packages\/\w+\/src\/.*(?<!\.work|\.verify)\.test\.ts$/, cost: TEST },
];

/**
 * Examples of exports, of the code that tests run.
 *
 * @param {ApiExport[]} api
 * @returns {Map<ApiExport, Example>} exports without an example are left out
 */
export function readExamples(api) {
  const index = new ExampleIndex(api);
  for (const { path, cost } of exampleFiles()) {
    const source = readFileSync(join(root, path), 'utf8');
    const blocks = path.endsWith('.md')
      ? [...source.matchAll(/^```(tsx?)\n(.*?)^```/gms)].map(({ 1: ending, 2: code, index }) => ({
          ...{ name: `block.${ending}`, code, above: source.slice(0, index).split('\n').length },
        }))
      : [{ name: path, code: source, above: 0 }];
    for (const { name, code, above } of blocks) index.add(path, name, code, above, cost);
  }
  index.lendToTypes();
  return index.found;
}

/** @returns {{ path: string, cost: number }[]} */
function exampleFiles() {
  return ['README.md', ...filesEnding('.ts', '.tsx', '.md')].flatMap((path) => {
    const source = sources.find(({ files }) => files.test(path));
    return source ? [{ path, cost: source.cost }] : [];
  });
}

class ExampleIndex {
  /** @type {Map<ApiExport, Example>} */
  found = new Map();
  /** Exports by `specifier name`, of each entry. @type {Map<string, ApiExport>} */
  byKey = new Map();
  /** Exports by `file name`, for relative imports. @type {Map<string, ApiExport>} */
  byFile = new Map();

  /** @param {ApiExport[]} api */
  constructor(api) {
    this.api = api;
    for (const each of api) {
      for (const entry of each.entries) this.byKey.set(`${entry} ${each.name}`, each);
      this.byFile.set(`${each.file.replace(/\.tsx?$/, '')} ${each.name}`, each);
    }
  }

  /**
   * @param {string} path
   * @param {string} name - of the code: tells TypeScript from TSX
   * @param {string} code
   * @param {number} above - lines of the file above the code
   * @param {number} cost
   */
  add(path, name, code, above, cost) {
    const excerpts = excerptsOf(name, code, (each) => this.publicName(path, each), path.endsWith('.test.ts'));
    for (const [key, excerpt] of excerpts) {
      const used = this.byKey.get(key);
      if (used === undefined) continue;
      const total = excerpt.cost + cost;
      if (total < (this.found.get(used)?.cost ?? Infinity))
        this.found.set(used, { ...excerpt, cost: total, line: excerpt.line + above, path, of: used.name });
    }
  }

  /** How a page imports a name. @param {string} path @param {import('./excerpts.mjs').Import} each */
  publicName(path, { specifier, imported }) {
    if (!specifier.startsWith('.'))
      return /^vitest$|\?raw$|^@farol\/tools/.test(specifier) ? null : { specifier, imported };
    const file = join(path, '..', specifier).replaceAll('\\', '/');
    const found = this.byFile.get(`${file} ${imported}`) ?? this.byFile.get(`${file}/index ${imported}`);
    return found ? { specifier: found.entries[0], imported } : null;
  }

  /** Gives types and classes without an example that of an export which takes or gives them. */
  lendToTypes() {
    const isType = (/** @type {ApiExport} */ { kind }) => kind !== 'function' && kind !== 'constant';
    for (let lenders = [...this.found.keys()]; lenders.length > 0;) {
      /** @type {ApiExport[]} */
      const next = [];
      for (const lender of lenders.toSorted((a, b) => this.costOf(a) - this.costOf(b)))
        for (const type of lender.types.filter(isType)) {
          const example = this.found.get(lender);
          const own = this.found.get(type);
          // a type's own example may be of a unit test: an example for readers that passes the type to a function tells more
          if (!example || (own && (own.cost < TEST || own.cost <= example.cost + TEST / 2))) continue;
          this.found.set(type, example);
          next.push(type);
        }
      lenders = next;
    }
  }

  /** @param {ApiExport} each */
  costOf(each) {
    return this.found.get(each)?.cost ?? 0;
  }
}
