import { spawn } from 'node:child_process';
import { stripVTControlCharacters } from 'node:util';
import { root } from './root.mjs';
import { toolPath } from './toolPath.mjs';

/** Line of Playwright's or Vitest's about a test that failed. */
const failedTest = /^\s*(✘|×|FAIL) /;

/** Processes that run, with the output of each that is not shown yet; null where it is shown as it comes. */
/** @type {Map<import('node:child_process').ChildProcess, Buffer[] | null>} */
const running = new Map();
let isEnding = false;

/**
 * Runs a script by Node at the top of the repository, so that others can run beside it.
 *
 * @param {string} script - path
 * @param {readonly string[]} args
 * @param {object} [options]
 * @param {Readonly<Record<string, string>>} [options.env] - added to this process's
 * @param {boolean} [options.isHeld] - whether its output is shown at its end, in one piece, but for a line for each failed test,
 *   which is shown at once; default false: as it comes
 * @returns {Promise<number>} its exit code; 1 when a signal ended it or it could not be started
 */
export function startScript(script, args, { env = {}, isHeld = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [script, ...args], {
      cwd: root,
      stdio: isHeld ? ['ignore', 'pipe', 'pipe'] : 'inherit',
      env: { ...process.env, ...env },
    });
    running.set(child, isHeld && !isEnding ? [] : null);
    let line = '';
    /** @param {Buffer} part */
    const hear = (part) => {
      const said = running.get(child);
      if (!said) return void process.stdout.write(part);
      said.push(part);
      const lines = `${line}${part}`.split('\n');
      line = lines.pop() ?? '';
      for (const each of lines) if (failedTest.test(stripVTControlCharacters(each))) process.stdout.write(`${each}\n`);
    };
    child.stdout?.on('data', hear);
    child.stderr?.on('data', hear);
    child.on('error', () => resolve(1));
    child.on('close', (code) => {
      show(child);
      running.delete(child);
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

/**
 * Lets a signal to end show at once what the scripts of this process have said, interrupt them, show what they say of that
 * (Playwright lists the tests that were running), and end the process with them. A second signal ends it at once.
 */
export function endWithScripts() {
  for (const [signal, code] of /** @type {const} */ ([
    ['SIGTERM', 143],
    ['SIGINT', 130],
    ['SIGHUP', 129],
  ])) {
    process.on(signal, () => {
      if (isEnding) process.exit(code);
      isEnding = true;
      console.log(`\nEnded by ${signal}; what runs had said until then:`);
      const ends = [...running.keys()].map((child) => {
        show(child);
        child.kill('SIGINT');
        return new Promise((resolve) => child.once('close', resolve));
      });
      void Promise.all(ends).then(() => process.exit(code));
    });
  }
}

/**
 * Shows what a process has said, and from then on what it says as it comes.
 *
 * @param {import('node:child_process').ChildProcess} child
 */
function show(child) {
  const said = running.get(child);
  if (said) process.stdout.write(Buffer.concat(said));
  running.set(child, null);
}
