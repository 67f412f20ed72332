import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { extractTar } from '@farol/tools/extractTar';

/** Places that `installPackages.ts` has made. */
export function installed(): { host: string; tarballs: string; peers: string; repositoryModules: string } {
  const folder = process.env.FAROL_INSTALLED;
  if (!folder) throw new Error('FAROL_INSTALLED is not set: run these tests by e2e/packages/playwright.config.ts.');
  return {
    host: join(folder, 'host'),
    tarballs: join(folder, 'tarballs'),
    peers: join(folder, 'with-peers'),
    repositoryModules: fileURLToPath(new URL('../../node_modules', import.meta.url)),
  };
}

export interface Tarball {
  readonly bytes: Buffer;
  /** Text by path in the package, such as `dist/index.js`. */
  readonly files: ReadonlyMap<string, string>;
}

/** Tarballs that `npm pack` made, in the order of the packages' names. */
export function readTarballs(): Tarball[] {
  const { tarballs } = installed();
  return readdirSync(tarballs).map((name) => {
    const bytes = readFileSync(join(tarballs, name));
    const files = extractTar(bytes, () => true).map(
      ({ path, bytes: text }) => [path.replace(/^package\//, ''), text.toString()] as const,
    );
    return { bytes, files: new Map(files) };
  });
}

const unpacked = new Map<string, Tarball>();

/** Tarball that `npm pack` made of a package. @throws Error when it made nothing */
export function readTarball(name: string): Tarball {
  for (const each of unpacked.size > 0 ? [] : readTarballs())
    unpacked.set(JSON.parse(each.files.get('package.json') ?? '{}').name, each);
  const found = unpacked.get(name);
  if (!found) throw new Error(`npm pack made nothing of ${name}.`);
  return found;
}
