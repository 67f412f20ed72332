import { dirname, join, normalize } from 'node:path/posix';
import { parseSync } from 'vite';
import { importsOf } from './importsOf.mjs';

/** The effects of the renderer, entries of their own; the option `antialias` draws by one of them. */
const effects = 'packages/renderer/src/effects';
/** Folders of the renderer that are entries of their own, which its core does not know at all. */
const aroundTheCore = [
  'packages/renderer/src/adapters',
  'packages/renderer/src/authoring',
  'packages/renderer/src/light-options',
  'packages/renderer/src/light-profiles',
  'packages/renderer/src/pixel-lighting',
  'packages/renderer/src/surfaces',
];

/** Folders of the renderer's sources, each after those that it may import; its core imports types alone of the effects. */
const rendererFolders = [
  ...['microshaders', 'lights', 'three', 'gpu', 'materials', 'surfaces', 'lighting', 'gbuffer', 'frame', 'passes'],
  ...['light-fields', 'views', 'shadows', 'techniques', 'effects', 'renderer'],
].map((folder) => `packages/renderer/src/${folder}`);

const rendererRules = rendererFolders.map((from, i) => ({
  from,
  may: ['three', ...rendererFolders.slice(0, i + 1)],
  tests: ['packages/renderer'],
  not: aroundTheCore.filter((folder) => folder !== from),
  types: from === effects ? [] : [effects],
}));

/** Folders of the editor's sources, each after those that it may import. */
const editorFolders = [
  ...[
    'style',
    'language',
    'model',
    'microshaders',
    'scripts',
    'viewport',
    'layout',
    'api',
    'files',
    'actions',
    'agent',
    'ui',
    'fields',
    'panels',
  ],
  'plugins',
];

/**
 * Floors of the engine's sources, each after those that it may import. Folders of one floor do not know each other.
 *
 * Assets are below scenes: a library is used by many scenes and knows none. Components are above animation, audio and physics:
 * a component is the thin part that an author sees, over the records and the system that do its work.
 */
const engineFloors = [
  // slices of long work, code fetched late, random numbers
  ['base'],
  ['fields'],
  // checks of untrusted files before they are read, and the error for refused ones
  ['guard'],
  ['geometry', 'textures', 'profiles', 'photometry', 'astronomy'],
  ['assets'],
  // settings of a scene as fields, and the sky that they paint
  ['settings'],
  // scenes, GameObjects, the base of components, baked light that is shown
  ['core'],
  ['animation', 'audio', 'physics', 'triggers'],
  ['components'],
  // 'bake' collects what is to be baked
  ['bake', 'files', 'picture', 'scripts'],
  ['prefabs'],
  ['app'],
];

/**
 * Packages besides three, the editing's and the renderer's that a folder of the engine may import.
 *
 * @type {Readonly<Record<string, readonly string[]>>}
 */
const engineOptional = {
  physics: ['@dimforge/rapier3d-compat'],
  picture: ['postprocessing'],
  scripts: ['sucrase'],
};

const engine = 'packages/engine/src';

const engineRules = engineFloors.flatMap((floor, i) =>
  floor.map((folder) => ({
    from: `${engine}/${folder}`,
    may: [engine, 'three', '@farol/editing', '@farol/renderer', ...(engineOptional[folder] ?? [])],
    not: ['index', 'componentFields', ...engineFloors.slice(i).flat()]
      .filter((each) => each !== folder)
      .map((each) => `${engine}/${each}`),
  })),
);

const editorRules = editorFolders.map((folder, i) => ({
  from: `apps/editor/src/${folder}`,
  may: ['*', ...editorFolders.slice(0, i + 1).map((each) => `apps/editor/src/${each}`)],
}));

/**
 * Who may import whom, as one table. A source file goes by the first row whose `from` is a folder above it; `may` lists
 * folders of the repository and packages, `not` folders in those that are left out, `types` folders of which types alone
 * may be imported, `fetches` folders that `import()` alone may fetch, `tests` what tests may import besides, `ofThree` the
 * only names of three's. Packages must also be declared by the file's workspace, and their exports name what may be
 * imported of them.
 *
 * In the renderer each folder knows those before it in `rendererFolders`; its other entries plug it into one library each,
 * are optional effects, or serve authors: its core knows none of them. That what is fetched late is not in the core is held
 * by `coreViolations`. Renderer, engine, editing and bake speak plain three; engine and attach -> editing, renderer;
 * mcp runs in Node and knows none of them; apps -> all; nothing imports apps; the browser tests use published entry points only. In the editor each folder knows
 * those before it: style, language, model <- microshaders <- scripts <- viewport; model <- layout; all of these <- api <-
 * files <- actions <- agent <- ui <- fields <- panels <- plugins <- Editor.ts. The engine's folders are in floors, see
 * `engineFloors`; their tests may look up.
 */
export const importRules = [
  { from: 'packages/renderer/src/microshaders', may: ['packages/renderer/src/microshaders', 'three'] },
  {
    // maths only: no WebGL, no textures, no renderers
    from: 'packages/renderer/src/lights',
    may: ['packages/renderer/src/lights', 'three'],
    ofThree: /^((Ambient|Directional|Hemisphere|Point|RectArea|Spot)?Light|\w*Camera|Vector\d|Matrix\d)$/,
  },
  { from: 'packages/renderer/src/adapters/three-pass', may: ['packages/renderer', 'three'] },
  { from: 'packages/renderer/src/adapters/postprocessing', may: ['packages/renderer', 'three', 'postprocessing'] },
  { from: 'packages/renderer/src/light-profiles', may: ['packages/renderer/src/light-profiles', 'three'] },
  { from: 'packages/renderer/src/pixel-lighting', may: ['packages/renderer', 'three'] },
  { from: 'packages/renderer/src/light-options', may: ['packages/renderer', 'three'] },
  { from: 'packages/renderer/src/authoring', may: ['packages/renderer', 'three'] },
  { from: 'packages/renderer/src/adapters/intercept', may: ['packages/renderer', 'three'] },
  { from: 'packages/renderer/src/adapters/r3f', may: ['packages/renderer', 'three', 'react', '@react-three/fiber'] },
  {
    from: 'packages/renderer/src/adapters/r3f-postprocessing',
    may: ['packages/renderer', 'three', 'react', '@react-three/fiber', '@react-three/postprocessing'],
  },
  {
    from: 'packages/renderer/src/renderer/lazyCode.ts',
    may: ['packages/renderer', 'three'],
    not: aroundTheCore,
    fetches: [effects],
  },
  ...rendererRules,
  { from: 'packages/renderer', may: ['packages/renderer', 'three'], not: [...aroundTheCore, effects] },
  ...engineRules,
  { from: 'packages/engine', may: ['packages/engine', 'three', '@farol/editing', '@farol/renderer'] },
  { from: 'packages/scenes', may: ['packages/scenes', 'three', '@farol/editing', '@farol/engine'] },
  {
    from: 'packages/bake',
    may: ['packages/bake', 'three', 'three-mesh-bvh', 'xatlas-wasm'],
  },
  { from: 'packages/editing', may: ['packages/editing', 'three'] },
  {
    from: 'packages/mcp',
    may: ['packages/mcp', '@modelcontextprotocol/sdk', 'ws', 'zod'],
  },
  { from: 'packages/attach', may: ['packages/attach', 'three', '@farol/renderer', '@farol/editing'] },
  { from: 'apps/viewer', may: ['apps/viewer', '*'] },
  { from: 'apps/site', may: ['apps/site', 'public', '*'] },
  {
    // of the Lab's other sources types alone, since the other engines are bundled apart from them
    from: 'apps/lab/rivals',
    may: ['apps/lab/rivals', 'apps/lab/src/competitors/rivals', '*'],
    types: ['apps/lab/src'],
  },
  { from: 'apps/lab', may: ['apps/lab', '*'], not: ['apps/lab/rivals'] },
  ...editorRules,
  { from: 'apps/editor', may: ['apps/editor', '*'] },
  { from: 'e2e', may: ['e2e', '*'] },
];

/** Packages that a build takes in, whole: who installs what was built does not need them. */
const takenIn = ['xatlas-wasm'];

/** Packages of the repository that nobody imports: an app is an end, not a part. */
const apps = ['@farol/viewer', '@farol/editor', '@farol/lab', '@farol/site'];

/**
 * Checks every import of a set of files against {@link importRules}.
 *
 * @param {ReadonlyMap<string, string>} files - source by path from the repository's root, with `/`
 * @param {ReadonlyMap<string, { name?: string, exports?: object, dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 *   package.json by workspace folder, '' for the root
 * @returns {string[]} one line a violation: file, import and why; empty when all is well
 */
export function importViolations(files, manifests) {
  const violations = [];
  for (const [path, source] of files) {
    const rule = importRules.find(({ from }) => path === from || path.startsWith(`${from}/`));
    if (!rule) continue;
    for (const { specifier, kind } of importsOf(path, source)) {
      const why = violation(path, specifier, kind, rule, manifests);
      if (why) violations.push(`${path} imports ${specifier}: ${why}`);
    }
    const { ofThree } = /** @type {{ ofThree?: RegExp }} */ (rule);
    if (ofThree === undefined || isTestCode(path)) continue;
    for (const name of namesOfThree(path, source)) {
      if (!ofThree.test(name))
        violations.push(`${path} imports ${name} of three: ${rule.from} may import ${ofThree} only`);
    }
  }
  return violations;
}

/** @typedef {import('./importsOf.mjs').ImportKind} ImportKind */

/**
 * @param {string} path
 * @param {string} specifier
 * @param {ImportKind} kind
 * @param {{ from: string, may: string[], not?: string[], types?: string[], fetches?: string[], tests?: string[] }} rule
 * @param {ReadonlyMap<string, { name?: string, exports?: object, dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 */
function violation(path, specifier, kind, { from, may, not = [], types = [], fetches = [], tests = [] }, manifests) {
  const forTests = isTestCode(path) || path.endsWith('.config.ts');
  if (specifier.startsWith('.')) {
    const target = normalize(join(dirname(path), specifier));
    const within = (/** @type {string} */ folder) => target === folder || target.startsWith(`${folder}/`);
    if (!forTests && target.includes('/testing/')) return 'product code does not use what tests share';
    if (!forTests && not.some(within)) return `${from} does not know what plugs it in`;
    if (!forTests && kind !== 'type' && types.some(within))
      return `of ${types.join(', ')} ${from} may import types only`;
    if (!forTests && kind === 'value' && fetches.some(within)) return `${from} may fetch it by import() only`;
    if (may.some(within) || (forTests && tests.some(within))) return null;
    if (forTests && target.startsWith('packages/tools/')) return null;
    return `${from} may import ${may.join(', ')} only`;
  }
  if (specifier.startsWith('node:')) {
    return forTests || ['e2e', 'packages/mcp'].includes(from) ? null : 'browser code has no Node modules';
  }
  // modules that a Vite plugin of the workspace makes
  if (specifier.startsWith('virtual:')) {
    return path.startsWith('apps/') ? null : 'packages are built without the plugins of apps';
  }
  const name = packageOf(specifier);
  if (apps.includes(name)) return 'nothing imports an app';
  if (name.startsWith('@farol/') && name !== '@farol/tools' && !entriesOf(name, manifests).includes(specifier)) {
    return `only the published entries of ${name} may be imported: ${entriesOf(name, manifests).join(', ')}`;
  }
  // Tests and configurations run from the root, and may use its tools on top.
  const ofRoot = name === '@farol/tools' || name in (manifests.get('')?.devDependencies ?? {});
  if (forTests && ofRoot) return null;
  if (!may.includes('*') && !may.includes(name)) return `${from} may import ${may.join(', ')} only`;
  return declared(name, path, manifests) ? null : `its workspace does not declare ${name}`;
}

/** Whether a file is a test, or in a folder of what tests share. @param {string} path */
export const isTestCode = (path) => /\.(test|bench)\.tsx?$|\/testing\//.test(path);

/**
 * Names that a file imports from three, '*' for all of it.
 *
 * @param {string} path @param {string} source @returns {string[]}
 */
function namesOfThree(path, source) {
  return parseSync(path, source)
    .module.staticImports.filter(({ moduleRequest }) => moduleRequest.value === 'three')
    .flatMap(({ entries }) => entries.map(({ importName }) => importName.name ?? '*'));
}

/**
 * Entries of a package of the repository, as import specifiers.
 *
 * @param {string} name
 * @param {ReadonlyMap<string, { name?: string, exports?: object }>} manifests
 */
function entriesOf(name, manifests) {
  const manifest = [...manifests.values()].find((manifest) => manifest.name === name);
  const entries = Object.entries(manifest?.exports ?? { '.': {} });
  return entries.flatMap(([entry, paths]) => (paths !== null && !entry.includes('*') ? name + entry.slice(1) : []));
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
 * @param {ReadonlyMap<string, { name?: string, exports?: object, dependencies?: object, peerDependencies?: object, devDependencies?: object }>} manifests
 */
function declared(name, path, manifests) {
  const workspace = [...manifests.keys()].find((folder) => folder !== '' && path.startsWith(`${folder}/`));
  // e2e is no workspace: it belongs to the root, whose packages are linked in
  if (workspace === undefined) return name.startsWith('@farol/') || name in (manifests.get('')?.devDependencies ?? {});
  const own = manifests.get(workspace);
  // apps and packages that are bundled whole may use devDependencies: nobody installs these to use what was built
  const isBuilt = path.startsWith('apps/') || takenIn.includes(name);
  return name in { ...own?.dependencies, ...own?.peerDependencies, ...(isBuilt ? own?.devDependencies : {}) };
}
