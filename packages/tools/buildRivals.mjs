import { copyFileSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { needsInstall } from './ensureInstalled.mjs';
import { rivalPackages, rivalsDist, rivalsFolder } from './rivalsPaths.mjs';
import { runNpm } from './runNpm.mjs';

/** @param {string} path */
const modified = (path) => statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? null;

/**
 * Installs the other engines into a folder of their own, unless that is done.
 *
 * @throws {Error} when npm ci fails
 */
export function installRivals() {
  const installed = modified(join(rivalsFolder, 'node_modules/.package-lock.json'));
  if (!needsInstall(installed, modified(join(rivalsFolder, 'package-lock.json')))) return;
  console.log('Installing the other engines (npm ci in apps/lab/rivals).');
  const { status } = runNpm(['ci'], { cwd: rivalsFolder });
  if (status !== 0) throw new Error('npm ci failed in apps/lab/rivals: see its message above; the network may be off.');
}

/** Leaves Babylon's shaders for WebGPU out, which WebGL 2 never runs. @returns {import('vite').Plugin} */
function withoutWgsl() {
  return {
    name: 'farol-without-wgsl',
    enforce: 'pre',
    resolveId: (id) => (/[\\/]ShadersWGSL[\\/]/.test(id) ? '\0farol-empty' : null),
    load: (id) => (id === '\0farol-empty' ? 'export {};' : null),
  };
}

/**
 * Bundles each engine and its conversion into one module of `apps/lab/rivals/dist`, with its licence, and notes their
 * versions.
 *
 * @returns {Promise<Record<string, { version: string, bytes: number }>>} by competitor's key
 */
export async function bundleRivals() {
  // else a development server's own NODE_ENV would get PlayCanvas with its debug checks
  process.env.NODE_ENV = 'production';
  const { build } = await import('vite');
  /** @type {Record<string, { version: string, bytes: number }>} */
  const built = {};
  mkdirSync(rivalsDist, { recursive: true });
  for (const [name, packageName] of Object.entries(rivalPackages)) {
    await build({
      root: rivalsFolder,
      configFile: false,
      publicDir: false,
      logLevel: 'warn',
      plugins: [withoutWgsl()],
      build: {
        target: 'es2022',
        outDir: rivalsDist,
        emptyOutDir: false,
        minify: true,
        reportCompressedSize: false,
        chunkSizeWarningLimit: 8000,
        lib: { entry: join(rivalsFolder, `src/${name}/${name}.ts`), formats: ['es'], fileName: () => `${name}.js` },
        rolldownOptions: { output: { codeSplitting: false } },
      },
    });
    const folder = join(rivalsFolder, 'node_modules', packageName);
    const licence = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
    if (licence === undefined) throw new Error(`${packageName} has no licence file: a build may not hand it on.`);
    copyFileSync(join(folder, licence), join(rivalsDist, `${name}.LICENSE.txt`));
    const manifest = readFileSync(join(folder, 'package.json'), 'utf8');
    built[name] = { version: JSON.parse(manifest).version, bytes: statSync(join(rivalsDist, `${name}.js`)).size };
  }
  const versions = Object.fromEntries(Object.entries(built).map(([name, { version }]) => [name, version]));
  writeFileSync(join(rivalsDist, 'versions.json'), `${JSON.stringify({ versions, canInstall: false }, null, 1)}\n`);
  return built;
}
