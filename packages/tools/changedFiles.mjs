import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * Files that differ from the last commit, new ones included; where there are none, those of the last commit.
 *
 * @param {string} [folder] - of the checkout; default this one's
 * @returns {string[]} paths from the folder, with `/`; those that are gone are left out
 * @throws {Error} outside of a git checkout
 */
export function changedFiles(folder = root) {
  /** @param {string[]} args @returns {string[]} lines of its output */
  const run = (...args) => git(folder, args);
  const changed = [...run('diff', '--name-only', 'HEAD'), ...run('ls-files', '--others', '--exclude-standard')];
  const all = changed.length > 0 ? changed : run('diff', '--name-only', 'HEAD~1', 'HEAD');
  return [...new Set(all)].filter((path) => existsSync(join(folder, path)));
}

/** @param {string} folder @param {string[]} args @returns {string[]} lines of its output */
function git(folder, args) {
  const { status, stdout, stderr } = spawnSync('git', args, { cwd: folder, encoding: 'utf8' });
  if (status !== 0) throw new Error(`git ${args[0]} failed, name the files that you have changed: ${stderr}`);
  return stdout.split('\n').filter(Boolean);
}
