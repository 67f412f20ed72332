import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { mkdir, rename, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import { posix } from 'node:path';
import { entriesOf, publishedPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';
import { toolPath } from './toolPath.mjs';

const ID = 'virtual:script-declarations';
/** Entries of the packages that a script's declarations reach. */
const specifiers = [
  '@farol/engine',
  '@farol/engine/fields',
  '@farol/editing/fields',
  '@farol/renderer',
  '@farol/renderer/authoring',
];
/** TypeScript's libraries that scripts may use. */
const libraries = ['es2023', 'dom', 'dom.iterable'];
/** Files of three's WebGPU renderer, which scripts do not have: a third of three's declarations. */
const leftOut = /\/src\/(nodes|materials\/nodes|renderers\/(common|webgpu))\//;

/**
 * @typedef {object} ScriptDeclarations
 * @property {Record<string, string>} files texts by path: `/lib/lib.es2023.d.ts`, `/three/…`, `/@farol/engine/…`
 * @property {Record<string, string>} modules paths of the files that modules are, by specifier
 * @property {string[]} globals paths of files that declare globals
 */

/**
 * The declarations that scripts are checked against: TypeScript's libraries, three and the engine. `tsc -b packages/engine`
 * must have written those of the engine.
 *
 * @returns {ScriptDeclarations}
 */
export function gatherDeclarations() {
  /** @type {ScriptDeclarations} */
  const found = { files: {}, modules: {}, globals: [] };
  const libraryFolder = join(root, 'node_modules/typescript-in-browser/lib');
  const addLibrary = (/** @type {string} */ name) => {
    const path = `/lib/lib.${name}.d.ts`;
    if (path in found.files) return;
    const text = readFileSync(join(libraryFolder, `lib.${name}.d.ts`), 'utf8');
    found.files[path] = text;
    for (const [, other] of text.matchAll(/\/\/\/ <reference lib="([^"]+)"/g)) addLibrary(other);
  };
  libraries.forEach(addLibrary);

  /**
   * Adds a file and those that it imports.
   * @param {string} folder - of the package, on this machine
   * @param {string} name - of the package
   * @param {string} file
   */
  const addFile = (folder, name, file) => {
    const path = posix.join('/', name, relative(folder, file).replaceAll('\\', '/'));
    if (path in found.files || leftOut.test(path)) return path;
    const text = withoutInternals(readFileSync(file, 'utf8').replace(/\n\/\/# sourceMappingURL=.*\s*$/, '\n'));
    found.files[path] = text;
    for (const [, specifier] of text.matchAll(/\b(?:from|import)\s*\(?\s*['"](\.[^'"]+)['"]/g)) {
      const place = join(dirname(file), specifier);
      const source = [place.replace(/\.js$/, '.d.ts'), `${place}.d.ts`, join(place, 'index.d.ts')].find(
        (each) => each.endsWith('.d.ts') && existsSync(each),
      );
      if (source) addFile(folder, name, source);
    }
    return path;
  };
  const typesOfThree = join(root, 'node_modules/@types/three');
  found.modules.three = addFile(typesOfThree, 'three', join(typesOfThree, 'build/three.module.d.ts'));
  const typesOfXR = join(root, 'node_modules/@types/webxr');
  found.globals.push(addFile(typesOfXR, 'webxr', join(typesOfXR, 'index.d.ts')));
  for (const { manifest, folder } of publishedPackages()) {
    for (const { specifier, source } of entriesOf(manifest).filter((each) => specifiers.includes(each.specifier))) {
      const types = join(root, '.cache/types', posix.basename(folder));
      const file = join(types, source.replace('./src/', '').replace(/\.ts$/, '.d.ts'));
      found.modules[specifier] = addFile(types, manifest.name, file);
    }
  }
  return found;
}

/**
 * A file of declarations without the members that are marked `@internal`.
 *
 * @param {string} text
 */
export function withoutInternals(text) {
  const kept = [];
  let depth = 0;
  let isLeftOut = false;
  for (const line of text.split('\n')) {
    if (!isLeftOut && /^\s*\/\*\* @internal\b.*\*\/$/.test(line)) {
      isLeftOut = true;
      depth = 0;
    } else if (isLeftOut) {
      depth += (line.match(/[{(]/g) ?? []).length - (line.match(/[)}]/g) ?? []).length;
      if (depth <= 0 && /[;}]$/.test(line)) isLeftOut = false;
    } else kept.push(line);
  }
  return kept.join('\n');
}

/** Writes the declarations of the engine from its sources; at once where nothing has changed. @returns {Promise<void>} */
const declareEngine = () =>
  new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [toolPath('typescript', 'tsc'), '-b', 'packages/engine'], {
      cwd: root,
      stdio: 'ignore',
    });
    child.on('error', reject);
    // sources with errors of types have declarations too
    child.on('exit', () => resolve());
  });

/**
 * Vite plugin: `import url from 'virtual:script-declarations'` gives the address of a JSON file, `ScriptDeclarations`. It is
 * made when it is first asked for, from the sources that there are then.
 *
 * @returns {import('vite').Plugin}
 */
export function scriptDeclarations() {
  return {
    name: 'farol-script-declarations',
    resolveId: (id) => (id === ID ? `\0${ID}` : null),
    async load(id) {
      if (id !== `\0${ID}`) return null;
      await declareEngine();
      const file = join(root, '.cache/scriptDeclarations.json');
      await mkdir(dirname(file), { recursive: true });
      // written beside it and renamed, since another server may be reading the file
      await writeFile(`${file}.${process.pid}`, JSON.stringify(gatherDeclarations()));
      await rename(`${file}.${process.pid}`, file);
      return `export { default } from ${JSON.stringify(`${file}?url`)};`;
    },
  };
}
