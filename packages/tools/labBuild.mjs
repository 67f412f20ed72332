import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/** Packages whose versions a run of the Lab names, where they are installed. */
const measured = ['three', 'playcanvas', '@babylonjs/core'];
/** Folders of `node_modules` that may hold them. */
const folders = ['.', 'apps/lab/rivals'];

/**
 * What the Lab's page knows of its own build, for Vite's `define`: `__FAROL_BUILD__`, version and commit, and
 * `__FAROL_VERSIONS__`, versions of the packages that are measured.
 *
 * @returns {Record<string, string>}
 */
export function labBuild() {
  const { version } = readJSON(join(root, 'packages/renderer/package.json'));
  const commit = describeCommit();
  const versions = measured.flatMap((name) => {
    const paths = folders.map((folder) => join(root, folder, 'node_modules', name, 'package.json'));
    const path = paths.find((each) => existsSync(each));
    return path === undefined ? [] : [[name, readJSON(path).version]];
  });
  return {
    __FAROL_BUILD__: JSON.stringify(commit === null ? version : `${version} (${commit})`),
    __FAROL_VERSIONS__: JSON.stringify(Object.fromEntries(versions)),
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
