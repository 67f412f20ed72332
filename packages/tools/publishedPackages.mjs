import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * @typedef {object} Manifest of a published package: what of package.json the tools read
 * @property {string} name
 * @property {string} version
 * @property {string[]} files
 * @property {Record<string, Partial<Record<'farol-source' | 'types' | 'default', string>> | string | null>} exports
 * @property {Record<string, string>} [dependencies]
 * @property {Record<string, string>} [peerDependencies]
 * @property {Record<string, { optional?: boolean }>} [peerDependenciesMeta]
 */

/** @typedef {{ folder: string, path: string, manifest: Manifest }} PublishedPackage folder: from the checkout; path: whole */

/**
 * Packages for the registry: each folder of packages/ whose package.json is not private.
 *
 * @param {string} [checkout] - folder of a repository; default this one
 * @returns {PublishedPackage[]} by name of the folder
 */
export function packedPackages(checkout = root) {
  return readdirSync(join(checkout, 'packages'), { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => ({ folder: `packages/${name}`, path: join(checkout, 'packages', name) }))
    .map((each) => ({ ...each, manifest: readManifest(each.path) }))
    .filter(({ manifest }) => !manifest.private);
}

/**
 * Packages for the registry that are built: those that have `exports`.
 *
 * @param {string} [checkout] - folder of a repository; default this one
 */
export const builtPackages = (checkout = root) => packedPackages(checkout).filter(({ manifest }) => manifest.exports);

/**
 * Packages for the registry that pages import: those built packages that use the page's own copy of three.
 *
 * @param {string} [checkout] - folder of a repository; default this one
 */
export const publishedPackages = (checkout = root) =>
  builtPackages(checkout).filter(({ manifest }) => manifest.peerDependencies?.three);

/** @param {string} folder @returns {Manifest & { private?: boolean }} its package.json */
export function readManifest(folder) {
  return JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
}

/**
 * Whether an import is left to the host: the package is a dependency or a peer, or a part of one.
 *
 * @param {Manifest} manifest - of the package that imports
 * @returns {(specifier: string) => boolean}
 */
export function leftToHost({ dependencies, peerDependencies }) {
  const names = Object.keys({ ...dependencies, ...peerDependencies });
  return (specifier) => names.some((name) => specifier === name || specifier.startsWith(`${name}/`));
}

/**
 * @typedef {object} Entry of a package, as `exports` names it
 * @property {string} specifier as a page imports it: `@farol/renderer/decals`
 * @property {string} name of its files in dist, without an extension: `decals`, `index` for the package's own name
 * @property {string} source from the package's folder
 */

/**
 * Entries of a package: what `exports` names one by one. Its patterns (`./*.js`, for import maps whose key ends in `/`)
 * lead to the same files.
 *
 * @param {Manifest} manifest
 * @returns {Entry[]}
 */
export function entriesOf({ name, exports }) {
  return Object.entries(exports ?? {}).flatMap(([entry, paths]) =>
    typeof paths === 'object' && paths?.['farol-source']
      ? [{ specifier: name + entry.slice(1), name: entry.slice(2) || 'index', source: paths['farol-source'] }]
      : [],
  );
}
