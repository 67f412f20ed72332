import { spawn } from 'node:child_process';
import { root } from './root.mjs';
import { toolPath } from './toolPath.mjs';

/**
 * Runs a script by Node at the top of the repository, so that others can run beside it.
 *
 * @param {string} script - path
 * @param {readonly string[]} args
 * @param {object} [options]
 * @param {Readonly<Record<string, string>>} [options.env] - added to this process's
 * @param {boolean} [options.isHeld] - whether its output is shown at its end, in one piece; default false: as it comes
 * @returns {Promise<number>} its exit code; 1 when a signal ended it or it could not be started
 */
export function startScript(script, args, { env = {}, isHeld = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [script, ...args], {
      cwd: root,
      stdio: isHeld ? ['ignore', 'pipe', 'pipe'] : 'inherit',
      env: { ...process.env, ...env },
    });
    /** @type {Buffer[]} */
    const said = [];
    child.stdout?.on('data', (part) => said.push(part));
    child.stderr?.on('data', (part) => said.push(part));
    child.on('error', () => resolve(1));
    child.on('close', (code) => {
      process.stdout.write(Buffer.concat(said));
      resolve(code ?? 1);
    });
  });
}

/**
 * Starts a command of an installed package.
 *
 * @param {string} packageName
 * @param {string} command
 * @param {readonly string[]} args
 * @param {Parameters<typeof startScript>[2]} [options] - as of {@link startScript}
 */
export const startTool = (packageName, command, args, options) =>
  startScript(toolPath(packageName, command), args, options);
