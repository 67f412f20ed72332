import { spawnSync } from 'node:child_process';
import { root } from './root.mjs';
import { toolPath } from './toolPath.mjs';

/**
 * Runs a command of an installed package at the top of the repository, its output passed on.
 *
 * @param {string} packageName
 * @param {string} command
 * @param {string[]} args
 * @param {Record<string, string>} [env] - added to this process's
 * @returns {number} its exit code; 1 when it was ended by a signal
 */
export function runTool(packageName, command, args, env = {}) {
  const done = spawnSync(process.execPath, [toolPath(packageName, command), ...args], {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, ...env },
  });
  return done.status ?? 1;
}
