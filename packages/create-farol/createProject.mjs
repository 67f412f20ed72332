import {
  copyFileSync,
  cpSync,
  existsSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import path, { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const templates = fileURLToPath(new URL('templates', import.meta.url));
/** Project name in the template files, replaced by the new project's. */
const NAME = 'farol-app';

/** Kinds of projects: description in the question, and the template folders to copy, later ones over earlier ones. */
export const kinds = /** @type {const} */ ({
  plain: { label: 'three.js alone', folders: ['base', 'lamps', 'plain'] },
  react: { label: 'React Three Fiber', folders: ['base', 'lamps', 'react'] },
  scene: { label: "a scene that Farol's editor saved", folders: ['base', 'scene'] },
});

/** @typedef {keyof typeof kinds} Kind */

/** Packages of Farol that other ones depend on: with tarballs, npm needs the paths of these too. */
export const behind = { '@farol/engine': ['@farol/editing', '@farol/renderer'] };

/** Error with a sentence for the user: what is wrong with an answer, and what to do. */
export class CreateError extends Error {}

/**
 * @typedef {object} Project
 * @property {string} folder - absolute path
 * @property {Kind} kind
 * @property {boolean} typescript - false: JavaScript
 * @property {string | null} [scene] - file of the editor's, in place of the sample
 * @property {string | null} [tarballs] - folder that `npm run pack` of a clone of Farol filled, in place of the
 *   registry
 */

/**
 * Reason why a project cannot be made in a folder, as a sentence; null when it can.
 *
 * @param {string} folder
 */
export function folderProblem(folder) {
  if (!existsSync(folder)) return null;
  const names = readdirSync(folder).filter((name) => name !== '.git');
  if (names.length === 0) return null;
  return `The folder ${folder} is not empty: choose another name, or empty it first.`;
}

/**
 * Package name from a folder's name: only characters that npm allows, in lower case.
 *
 * @param {string} folder
 */
export function packageName(folder) {
  const [last] = folder.split(/[\\/]/).slice(-1);
  const name = last
    .toLowerCase()
    .replaceAll(/[^a-z\d._~-]+/g, '-')
    .replaceAll(/^[._-]+|-+$/g, '');
  return name || NAME;
}

/**
 * Writes the files of a project.
 *
 * @param {Project} project
 * @throws {CreateError} when the folder is not empty, or the scene or tarballs do not exist; nothing is written then
 */
export function createProject({ folder, kind, typescript, scene = null, tarballs = null }) {
  const problem = folderProblem(folder);
  if (problem !== null) throw new CreateError(problem);
  if (scene !== null && !existsSync(scene)) throw new CreateError(`There is no file ${scene}: name a saved one.`);
  const { folders } = kinds[kind];
  const manifest = JSON.parse(readFileSync(join(templates, kind, 'package.json'), 'utf8'));
  if (tarballs !== null) useTarballs(folder, manifest, farolTarballs(tarballs));

  for (const part of folders) cpSync(join(templates, part), folder, { recursive: true });
  // npm omits .gitignore files from packages
  renameSync(join(folder, '_gitignore'), join(folder, '.gitignore'));
  if (scene !== null) putScene(folder, scene);
  const name = packageName(folder);
  for (const file of ['index.html', 'README.md']) edit(join(folder, file), (text) => text.replaceAll(NAME, name));
  if (!typescript) toJavaScript(folder, manifest);
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ ...manifest, name }, null, 2)}\n`);
}

/** @param {string} file @param {(text: string) => string} change */
function edit(file, change) {
  writeFileSync(file, change(readFileSync(file, 'utf8')));
}

/**
 * Replaces the sample by a saved scene, named `scene` with its own extension.
 *
 * @param {string} folder
 * @param {string} scene
 */
function putScene(folder, scene) {
  const name = `scene${extname(scene)}`;
  rmSync(join(folder, 'public/scene.json'));
  copyFileSync(scene, join(folder, 'public', name));
  edit(join(folder, 'src/main.ts'), (text) => text.replace('./scene.json', `./${name}`));
}

/**
 * Renames the sources to JavaScript, which their text already is, and removes TypeScript.
 *
 * @param {string} folder
 * @param {{ scripts: Record<string, string>, devDependencies: Record<string, string> }} manifest - changed
 */
function toJavaScript(folder, manifest) {
  for (const file of ['vite.config.ts', ...readdirSync(join(folder, 'src')).map((name) => `src/${name}`)])
    renameSync(join(folder, file), join(folder, file.replace(/\.ts(x?)$/, '.js$1')));
  rmSync(join(folder, 'tsconfig.json'));
  edit(join(folder, 'index.html'), (text) => text.replace(/(src\/main)\.ts(x?)/, '$1.js$2'));
  manifest.scripts.build = 'vite build';
  for (const name of Object.keys(manifest.devDependencies))
    if (name === 'typescript' || name.startsWith('@types/')) delete manifest.devDependencies[name];
}

/**
 * Finds the tarballs of Farol's packages in a folder, by package name.
 *
 * @param {string} tarballs
 * @returns {Map<string, string>} paths
 * @throws {CreateError} when there are none
 */
function farolTarballs(tarballs) {
  const names = existsSync(tarballs) ? readdirSync(tarballs) : [];
  const found = names.flatMap((name) => {
    const [, part] = /^farol-([a-z-]+)-\d.*\.tgz$/.exec(name) ?? [];
    return part ? [/** @type {const} */ ([`@farol/${part}`, join(tarballs, name)])] : [];
  });
  if (found.length > 0) return new Map(found);
  throw new CreateError(`There are no packages of Farol in ${tarballs}: run "npm run pack" in a clone of Farol.`);
}

/**
 * Makes npm install Farol's packages from tarballs.
 *
 * @param {string} folder
 * @param {{ dependencies: Record<string, string> }} manifest - changed
 * @param {ReadonlyMap<string, string>} packed
 */
function useTarballs(folder, manifest, packed) {
  const names = Object.keys(manifest.dependencies).filter((name) => name.startsWith('@farol/'));
  for (const name of names.flatMap((each) => [each, ...(behind[/** @type {keyof typeof behind} */ (each)] ?? [])])) {
    const tarball = packed.get(name);
    if (!tarball) throw new CreateError(`There is no package ${name} among the tarballs: run "npm run pack" again.`);
    manifest.dependencies[name] = fileSpecifier(folder, tarball);
  }
}

/**
 * Specifier of a file in package.json.
 *
 * @param {string} folder - absolute path of the folder with package.json
 * @param {string} file - absolute path
 * @param {Pick<typeof path, 'relative'>} [paths] - Node's `path` of another operating system, for tests
 */
export function fileSpecifier(folder, file, { relative } = path) {
  return `file:${relative(folder, file).replaceAll('\\', '/')}`;
}
