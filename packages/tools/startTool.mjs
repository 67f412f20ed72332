import { spawn } from 'node:child_process';
import { root } from './root.mjs';
import { toolPath } from './toolPath.mjs';

/**
 * Starts a command of an installed package at the top of the repository, its output passed on, so that others can run
 * beside it.
 *
 * @param {string} packageName
 * @param {string} command
 * @param {string[]} args
 * @returns {Promise<number>} its exit code; 1 when it was ended by a signal or could not be started
 */
export function startTool(packageName, command, args) {
  return new Promise((resolve) => {
    const tool = spawn(process.execPath, [toolPath(packageName, command), ...args], { cwd: root, stdio: 'inherit' });
    tool.on('error', () => resolve(1));
    tool.on('close', (code) => resolve(code ?? 1));
  });
}
