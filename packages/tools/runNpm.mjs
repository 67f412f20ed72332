import { spawnSync } from 'node:child_process';
import { root } from './root.mjs';

/**
 * Runs npm, the one that started this process if there is one.
 *
 * @param {string[]} args
 * @param {object} [options]
 * @param {string} [options.cwd] - default the top of the repository
 * @param {boolean} [options.isQuiet] - keeps its output back; default false: the output is passed on
 * @returns {{ status: number, stdout: string, stderr: string }} exit code, 1 when a signal ended npm; what a quiet npm said
 */
export function runNpm(args, { cwd = root, isQuiet = false } = {}) {
  /** @type {import('node:child_process').SpawnSyncOptionsWithStringEncoding} */
  const options = { cwd, stdio: isQuiet ? 'pipe' : 'inherit', encoding: 'utf8' };
  const npm = process.env.npm_execpath; // npm's own script, which node runs without a shell
  const { status, stdout, stderr } = npm
    ? spawnSync(process.execPath, [npm, ...args], options)
    : spawnSync('npm', args, { ...options, shell: process.platform === 'win32' });
  return { status: status ?? 1, stdout: stdout ?? '', stderr: stderr ?? '' };
}
