import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { dirname, normalize } from 'node:path/posix';
import { parseSync } from 'vite';
import { entriesOf, publishedPackages } from '../../publishedPackages.mjs';
import { root } from '../../root.mjs';
import { declarationsOf } from './declarations.mjs';

/**
 * A public export.
 *
 * @typedef {import('./declarations.mjs').Declaration & Place} ApiExport
 *
 * @typedef {object} Place
 * @property {string} name
 * @property {string} file - from the repository's root
 * @property {string[]} entries - as pages import it, first the entry whose page shows it
 * @property {ApiExport[]} types - exports that its signatures name
 */

/** A file's exports by name: where each is declared, and by which name. @typedef {Map<string, { file: string, local: string }>} Exports */

/** A name that a file imports. @typedef {{ from: string, name: string }} Import */

/**
 * Public exports of all packages that pages import, from their sources.
 *
 * @returns {ApiExport[]} in the order of packages, entries and their lists
 */
export function readApi() {
  const reader = new Reader();
  /** @type {Map<string, ApiExport>} */
  const found = new Map();
  for (const [specifier, file] of reader.entries) {
    for (const [name, { file: from, local }] of reader.exportsOf(file)) {
      const key = `${from} ${local}`;
      const before = found.get(key);
      const declaration = reader.declarations(from).get(local);
      if (before) before.entries.push(specifier);
      else if (declaration === undefined) throw new Error(`${specifier}: ${name} is not declared in ${from}.`);
      else if (!declaration.doc.isInternal)
        found.set(key, { ...declaration, name, file: from, entries: [specifier], types: [] });
    }
  }
  const api = [...found.values()];
  const packages = publishedPackages();
  for (const { file, entries } of api) {
    const own = packages.find(({ folder }) => file.startsWith(`${folder}/`))?.manifest.name;
    // the package that declares it shows it
    entries.sort((a, b) => Number(b.startsWith(`${own}`)) - Number(a.startsWith(`${own}`)));
  }
  for (const each of api) {
    const keys = reader.keysOf(each.file, each.mentions, found);
    each.types = keys.flatMap((key) => found.get(key) ?? []).filter((type) => type !== each);
    each.members = each.members.map((member) => (member.doc.text ? member : inherited(member, each)));
  }
  return api;
}

/**
 * A member without a text, with that of the class or interface that declares it.
 *
 * @param {import('./declarations.mjs').ApiMember} member @param {ApiExport} of
 */
function inherited(member, of) {
  const heads = of.types.filter(({ name }) => new RegExp(`(extends|implements).*\\b${name}\\b`).test(of.signatures[0]));
  const found = heads.flatMap(({ members }) => members).find(({ name, doc }) => name === member.name && doc.text);
  return found ? { ...member, doc: found.doc } : member;
}

class Reader {
  /** Files of entries, by specifier. @type {Map<string, string>} */
  entries = new Map(
    publishedPackages().flatMap(({ folder, manifest }) =>
      entriesOf(manifest).map(({ specifier, source }) => [specifier, normalize(join(folder, source))]),
    ),
  );
  /** @type {Map<string, Exports>} */
  exports = new Map();
  /** @type {Map<string, Map<string, Import>>} */
  imports = new Map();
  /** @type {Map<string, Map<string, import('./declarations.mjs').Declaration>>} */
  declared = new Map();

  /** @param {string} file */
  declarations(file) {
    let found = this.declared.get(file);
    if (found === undefined) {
      found = declarationsOf(file, readFileSync(join(root, file), 'utf8'));
      this.declared.set(file, found);
    }
    return found;
  }

  /** Key of the declaration that a name of a file stands for. @param {string} file @param {string} name */
  keyOf(file, name) {
    this.exportsOf(file);
    const imported = this.imports.get(file)?.get(name);
    const from = imported && this.resolve(file, imported.from);
    if (!imported || from === undefined) return imported ? '' : `${file} ${name}`;
    const there = this.exportsOf(from).get(imported.name);
    return there ? `${there.file} ${there.local}` : '';
  }

  /**
   * Keys of the exports that names of a file stand for; a name that is no export stands for what its declaration names.
   *
   * @param {string} file @param {Iterable<string>} names @param {ReadonlyMap<string, ApiExport>} api
   * @param {Set<string>} seen - keys so far
   */
  keysOf(file, names, api, seen = new Set()) {
    for (const key of [...names].map((name) => this.keyOf(file, name))) {
      if (seen.has(key)) continue;
      seen.add(key);
      const [from, local] = key.split(' ');
      const hidden = api.has(key) || !local ? undefined : this.declarations(from).get(local);
      if (hidden) this.keysOf(from, hidden.mentions, api, seen);
    }
    return [...seen];
  }

  /** @param {string} file @returns {Exports} */
  exportsOf(file) {
    const before = this.exports.get(file);
    if (before !== undefined) return before;
    /** @type {Exports} */
    const found = new Map();
    this.exports.set(file, found);
    const { module } = parseSync(file, readFileSync(join(root, file), 'utf8'));
    /** @type {Map<string, Import>} */
    const imports = new Map(
      module.staticImports.flatMap(({ moduleRequest, entries }) =>
        entries.map(({ importName, localName }) => [
          localName.value,
          { from: moduleRequest.value, name: importName.name ?? '*' },
        ]),
      ),
    );
    this.imports.set(file, imports);
    for (const { entries } of module.staticExports)
      for (const { moduleRequest, importName, exportName, localName } of entries) {
        const local = localName.name ?? exportName.name ?? '';
        const imported = moduleRequest
          ? { from: moduleRequest.value, name: importName.name ?? '*' }
          : imports.get(local);
        const name = exportName.name ?? '*';
        if (imported === undefined) {
          found.set(name, { file, local });
          continue;
        }
        const from = this.resolve(file, imported.from);
        if (from === undefined) continue;
        const there = this.exportsOf(from);
        if (imported.name === '*') for (const [each, at] of there) found.set(each, at);
        else found.set(name, there.get(imported.name) ?? { file: from, local: imported.name });
      }
    return found;
  }

  /** File of an import of ours; undefined for other packages'. @param {string} file @param {string} specifier */
  resolve(file, specifier) {
    if (!specifier.startsWith('.')) return this.entries.get(specifier);
    const path = normalize(join(dirname(file), specifier));
    return [path, `${path}.ts`, `${path}.tsx`, `${path}/index.ts`].find(
      (each) => /\.tsx?$/.test(each) && existsSync(join(root, each)),
    );
  }
}
