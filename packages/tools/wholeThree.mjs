import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { root } from './root.mjs';

const ID = 'virtual:whole-three';
const REST = '\0three-rest/';
const three = join(root, 'node_modules/three');
/** What imports three by name in the editor's pages. */
const sources = ['packages/renderer/src', 'packages/engine/src', 'packages/editing/src', 'apps/editor/src'];
const libraries = ['node_modules/postprocessing/build/index.js', 'node_modules/three-mesh-bvh/src/index.js'];
/** What of three's sources may come apart from the rest, since nothing else builds on it. */
const apart = new RegExp(
  [
    '^(audio|extras/(core|curves)|geometries|helpers|objects)/',
    '^cameras/Stereo',
    '^core/(Clock|GLBufferAttribute|Uniform)',
    '^loaders/(Animation|Audio|BufferGeometry|Compressed|CubeTexture|ImageBitmap|Material|Object)',
    '^math/(Box2|Cylindrical|Line3|SphericalHarmonics3)',
    '^textures/(Framebuffer|HTML|Video)',
  ].join('|'),
);

/** Names that a text imports of three. @param {string} text */
const importedNames = (text) =>
  [...text.matchAll(/\bimport\s*\{([^}]*)\}\s*from\s*['"]three['"]/g)].flatMap(([, list]) =>
    list.split(',').map(
      (each) =>
        each
          .replace(/\btype\s+\w+/, '')
          .trim()
          .split(/\s+as\s+/)[0],
    ),
  );

/** @param {string} file @param {Set<string>} seen @returns {string[]} */
function namesInModule(file, seen) {
  if (seen.has(file)) return [];
  seen.add(file);
  let text;
  try {
    text = readFileSync(file, 'utf8');
  } catch {
    return [];
  }
  const relatives = [...text.matchAll(/\bfrom\s*['"](\.[^'"]+)['"]/g)].map(([, path]) => join(dirname(file), path));
  return [...importedNames(text), ...relatives.flatMap((path) => namesInModule(path, seen))];
}

/** What the editor's pages import of three by name. */
function usedNames() {
  const seen = new Set();
  const names = libraries.flatMap((path) => namesInModule(join(root, path), seen));
  for (const folder of sources) {
    for (const path of readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })) {
      if (!/\.tsx?$/.test(path) || /\.test\.tsx?$/.test(path)) continue;
      const text = readFileSync(join(root, folder, path), 'utf8');
      names.push(...importedNames(text));
      for (const [, addon] of text.matchAll(/['"]three\/addons\/([^'"]+)['"]/g))
        names.push(...namesInModule(join(three, 'examples/jsm', addon), seen));
    }
  }
  return new Set(names);
}

/** The names that each file of three's sources exports, by its path, as far as three exports them. @returns {Map<string, string[]>} */
function exportsOfThree() {
  /** @type {Map<string, string[]>} */
  const files = new Map();
  const read = (/** @type {string} */ entry) => {
    const text = readFileSync(join(three, 'src', entry), 'utf8');
    const within = (/** @type {string} */ path) => posix.join(posix.dirname(entry), path);
    for (const [, list, path] of text.matchAll(/^export \{([^}]*)\} from '([^']+)';/gm)) {
      const names = list.split(',').map(
        (each) =>
          each
            .trim()
            .split(/\s+as\s+/)
            .at(-1) ?? '',
      );
      files.set(within(path), [...(files.get(within(path)) ?? []), ...names]);
    }
    for (const [, path] of text.matchAll(/^export \* from '([^']+)';/gm)) {
      const other = within(path);
      const { own, isIndex } = exportsOf(other);
      if (isIndex) read(other);
      else files.set(other, own);
    }
  };
  read('Three.js');
  return files;
}

/** What a file of three's sources exports itself, and whether it is a list of others. @param {string} path */
function exportsOf(path) {
  const text = readFileSync(join(three, 'src', path), 'utf8');
  const own = [...text.matchAll(/^export (?:async )?(?:class|function\*?|const|let) (\w+)/gm)].map(([, name]) => name);
  const listed = [...text.matchAll(/^export \{([^}]*)\};/gm)].flatMap(([, list]) =>
    list.split(',').map(
      (each) =>
        each
          .trim()
          .split(/\s+as\s+/)
          .at(-1) ?? '',
    ),
  );
  return {
    own: [...own, ...listed].filter((name) => name !== ''),
    isIndex: /^export (\*|\{[^}]*\}) from/m.test(text),
    hasDefault: /^export default/m.test(text),
  };
}

/**
 * Vite plugin: `virtual:whole-three` is all of three, for scripts. What the page's own code uses of it is the same module; the
 * rest comes from three's sources, which import what they build on from that module, so that it is fetched with this alone.
 *
 * @returns {import('vite').Plugin}
 */
export function wholeThree() {
  /** Paths in three's sources of what comes apart, and all paths with their names. */
  let rest = new Set();
  let all = new Map();
  /** All names that three exports. */
  let names = new Set();
  let isServed = false;
  /** Whether three exports all that one of its files does. */
  const isPublic = (/** @type {string} */ path) => {
    const { own, isIndex, hasDefault } = exportsOf(path);
    return !isIndex && !hasDefault && own.every((name) => names.has(name));
  };
  return {
    name: 'farol-whole-three',
    enforce: 'pre',
    /** @param {{ command: string }} config */
    async configResolved(config) {
      isServed = config.command === 'serve';
      if (isServed) return;
      names = new Set(Object.keys(await import('three')));
      const used = usedNames();
      all = exportsOfThree();
      const playsSound = [...used].some((name) => name.includes('Audio'));
      rest = new Set(
        [...all]
          .filter(
            ([path, names]) =>
              apart.test(path) &&
              !(playsSound && path.startsWith('audio/')) &&
              !names.some((/** @type {string} */ name) => used.has(name)),
          )
          .map(([path]) => path),
      );
    },
    resolveId(source, importer) {
      if (source === ID) return `\0${ID}`;
      if (source.startsWith(REST)) return source;
      if (!importer?.startsWith(REST) || !source.startsWith('.')) return null;
      const path = posix.join(posix.dirname(importer.slice(REST.length)), source);
      // one class for all: what the page has is not made twice
      return isPublic(path) && !rest.has(path) ? this.resolve('three', join(root, 'package.json')) : REST + path;
    },
    async load(id) {
      if (id.startsWith(REST)) {
        const path = id.slice(REST.length);
        const text = readFileSync(join(three, 'src', path), 'utf8');
        // all of a file is named: it may lead to all of three
        return text.replace(/^export \* from '([^']+)';/gm, (_, other) => {
          const { own } = exportsOf(posix.join(posix.dirname(path), other));
          return `export { ${own.join(', ')} } from '${other}';`;
        });
      }
      if (id !== `\0${ID}`) return null;
      if (isServed) return `export * from 'three';`;
      const restNames = new Set([...rest].flatMap((path) => all.get(path)));
      const shared = [...names].filter((name) => !restNames.has(name));
      const lines = [...rest].map(
        (path) => `export { ${all.get(path).join(', ')} } from ${JSON.stringify(REST + path)};`,
      );
      return [`export { ${shared.join(', ')} } from 'three';`, ...lines].join('\n');
    },
  };
}
