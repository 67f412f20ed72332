import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * Constants of the Lab's build for Vite's `define`: `__FAROL_BUILD__`, its version and commit, and `__FAROL_VERSIONS__`, that
 * of three.
 *
 * @returns {Record<string, string>}
 */
export function labBuild() {
  const { version } = readJSON(join(root, 'packages/renderer/package.json'));
  const commit = describeCommit();
  const { version: three } = readJSON(join(root, 'node_modules/three/package.json'));
  return {
    __FAROL_BUILD__: JSON.stringify(commit === null ? version : `${version} (${commit})`),
    __FAROL_VERSIONS__: JSON.stringify({ three }),
  };
}

/** Short name of the commit that is checked out, `-dirty` after it where files differ; null without git. */
function describeCommit() {
  try {
    const args = ['describe', '--always', '--dirty', '--abbrev=7', '--exclude=*'];
    return execFileSync('git', args, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim();
  } catch {
    return null;
  }
}

/** @param {string} path @returns {{ version: string }} */
function readJSON(path) {
  return JSON.parse(readFileSync(path, 'utf8'));
}
