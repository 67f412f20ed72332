import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { packedPackages } from './publishedPackages.mjs';
import { runNpm } from './runNpm.mjs';

/**
 * Packs all packages for the registry, as `npm publish` would. Those that are built must be.
 *
 * @param {string} to - folder, made where it is missing
 * @returns {string[]} tarballs
 * @throws {Error} with npm's words when one cannot be packed
 */
export function packPackages(to) {
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
