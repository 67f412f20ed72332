import { existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { builtPackages, packedPackages } from './publishedPackages.mjs';
import { runNpm } from './runNpm.mjs';

/**
 * Packs all packages for the registry, as `npm publish` would.
 *
 * @param {string} to - folder, made where it is missing
 * @returns {string[]} tarballs
 * @throws {Error} when one is not built, and with npm's words when one cannot be packed
 */
export function packPackages(to) {
  checkBuilt();
  mkdirSync(to, { recursive: true });
  const packed = packedPackages();
  const folders = packed.map(({ folder }) => `./${folder}`);
  const { status, stdout, stderr } = runNpm(['pack', ...folders, '--json', '--pack-destination', to], {
    isQuiet: true,
  });
  if (status !== 0) throw new Error(`npm pack failed:\n${stdout}${stderr}`);
  return packed.map(({ manifest }) => join(to, tarballName(manifest)));
}

/** @param {{ name: string, version: string }} manifest @returns {string} file that `npm pack` makes of the package */
export function tarballName({ name, version }) {
  return `${name.replace(/^@/, '').replace('/', '-')}-${version}.tgz`;
}

/**
 * @param {string} [checkout] - folder of a repository; default this one
 * @throws {Error} that names a package whose files are not all built
 */
export function checkBuilt(checkout) {
  for (const { folder, path, manifest } of builtPackages(checkout)) {
    const files = Object.values(manifest.exports).flatMap((entry) =>
      typeof entry === 'string' ? entry : [entry?.types, entry?.default],
    );
    const missing = files.find((file) => file && !file.includes('*') && !existsSync(join(path, file)));
    if (missing) throw new Error(`${folder} has no ${missing}: npm run pack builds the packages and packs them.`);
  }
}
