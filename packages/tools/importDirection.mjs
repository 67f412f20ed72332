import { dirname, join, normalize } from 'node:path/posix';
import { parseSync } from 'vite';

/**
 * Who may import whom, as one table. A source file goes by the first row whose `from` is a folder above it; `may` lists
 * folders of the repository and packages. Packages must also be declared by the file's workspace.
 *
 * microshaders <- the rest of renderer; renderer and engine speak plain three; engine -> renderer; apps -> both;
 * nothing imports apps; the browser tests use published entry points only.
 */
export const importRules = [
  { from: 'packages/renderer/src/microshaders', may: ['packages/renderer/src/microshaders', 'three'] },
  { from: 'packages/renderer', may: ['packages/renderer', 'three'] },
  { from: 'packages/engine', may: ['packages/engine', 'three', '@farol/renderer'] },
  { from: 'apps/viewer', may: ['apps/viewer', '*'] },
  { from: 'apps/editor', may: ['apps/editor', '*'] },
  { from: 'e2e', may: ['e2e', '*'] },
];

/** Packages of the repository that nobody imports: an app is an end, not a part. */
const apps = ['@farol/viewer', '@farol/editor'];

/**
 * Checks every import of a set of files against {@link importRules}.
 *
 * @param {ReadonlyMap<string, string>} files source by path from the repository's root, with `/`
 * @param {ReadonlyMap<string, { dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 *   package.json by workspace folder, '' for the root
 * @returns {string[]} one line a violation: file, import and why; empty when all is well
 */
export function importViolations(files, manifests) {
  const violations = [];
  for (const [path, source] of files) {
    const rule = importRules.find(({ from }) => path.startsWith(`${from}/`));
    if (!rule) continue;
    for (const specifier of importsOf(path, source)) {
      const why = violation(path, specifier, rule, manifests);
      if (why) violations.push(`${path} imports ${specifier}: ${why}`);
    }
  }
  return violations;
}

/**
 * @param {string} path
 * @param {string} specifier
 * @param {{ from: string, may: string[] }} rule
 * @param {ReadonlyMap<string, { dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 */
function violation(path, specifier, { from, may }, manifests) {
  const forTests = /\.(test|bench)\.tsx?$|(^|\/)\w+\.config\.ts$/.test(path);
  if (specifier.startsWith('.')) {
    const target = normalize(join(dirname(path), specifier));
    if (may.some((folder) => target === folder || target.startsWith(`${folder}/`))) return null;
    if (forTests && target.startsWith('packages/tools/')) return null;
    return `${from} may import ${may.join(', ')} only`;
  }
  if (specifier.startsWith('node:')) {
    return forTests || from === 'e2e' ? null : 'browser code has no Node modules';
  }
  const name = packageOf(specifier);
  if (apps.includes(name)) return 'nothing imports an app';
  if (name.startsWith('@farol/') && name !== '@farol/tools' && specifier !== name) {
    return `only the published entry ${name} may be imported`;
  }
  // Tests and configurations run from the root, and may use its tools on top.
  const ofRoot = name === '@farol/tools' || name in (manifests.get('')?.devDependencies ?? {});
  if (forTests && ofRoot) return null;
  if (!may.includes('*') && !may.includes(name)) return `${from} may import ${may.join(', ')} only`;
  return declared(name, path, manifests) ? null : `its workspace does not declare ${name}`;
}

/** @param {string} specifier */
function packageOf(specifier) {
  return specifier
    .split('/')
    .slice(0, specifier.startsWith('@') ? 2 : 1)
    .join('/');
}

/**
 * @param {string} name @param {string} path
 * @param {ReadonlyMap<string, { dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 */
function declared(name, path, manifests) {
  const workspace = [...manifests.keys()].find((folder) => folder !== '' && path.startsWith(`${folder}/`));
  // e2e is no workspace: it belongs to the root, whose packages are linked in
  if (workspace === undefined) return name.startsWith('@farol/') || name in (manifests.get('')?.devDependencies ?? {});
  const own = manifests.get(workspace);
  return name in { ...own?.dependencies, ...own?.peerDependencies };
}

/**
 * Specifiers of all static and dynamic imports and re-exports of a TypeScript file.
 *
 * @param {string} path @param {string} source @returns {string[]}
 */
function importsOf(path, source) {
  const { module } = parseSync(path, source);
  const text = (/** @type {{ start: number, end: number }} */ { start, end }) => source.slice(start, end);
  return [
    ...module.staticImports.map((entry) => entry.moduleRequest.value),
    ...module.staticExports.flatMap(({ entries }) =>
      entries.flatMap(({ moduleRequest }) => (moduleRequest ? [moduleRequest.value] : [])),
    ),
    ...module.dynamicImports.flatMap(({ moduleRequest }) => /^['"](.*)['"]$/.exec(text(moduleRequest))?.[1] ?? []),
  ];
}
