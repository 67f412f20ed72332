import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * Files that differ from the last commit, new ones included; where there are none, those of the last commit.
 *
 * @returns {string[]} paths from the repository's root, with `/`; those that are gone are left out
 * @throws {Error} outside of a git checkout
 */
export function changedFiles() {
  const changed = [...git('diff', '--name-only', 'HEAD'), ...git('ls-files', '--others', '--exclude-standard')];
  const all = changed.length > 0 ? changed : git('diff', '--name-only', 'HEAD~1', 'HEAD');
  return [...new Set(all)].filter((path) => existsSync(join(root, path)));
}

/** @param {string[]} args @returns {string[]} lines of its output */
function git(...args) {
  const { status, stdout, stderr } = spawnSync('git', args, { cwd: root, encoding: 'utf8' });
  if (status !== 0) throw new Error(`git ${args[0]} failed, name the files that you have changed: ${stderr}`);
  return stdout.split('\n').filter(Boolean);
}
