import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { findBrowser } from './findBrowser.mjs';
import { toolPath } from './toolPath.mjs';

/**
 * @typedef {object} InstallWorld what the installation may do; tests give a made-up one
 * @property {() => import('./findBrowser.mjs').FoundBrowser | null} find
 * @property {(path: string) => boolean} starts whether the browser runs on this machine (all its libraries there)
 * @property {(command: string, args: string[]) => boolean} run true when the command ended well
 * @property {boolean} debianRoot whether apt-get can be used: Debian-like and root
 * @property {(line: string) => void} say
 */

/** @returns {InstallWorld} */
function thisMachine() {
  return {
    find: () => findBrowser(),
    // Tried on Linux alone: elsewhere browsers bring their libraries, and on Windows `--version` would open a window.
    starts: (path) =>
      process.platform !== 'linux' || spawnSync(path, ['--version'], { timeout: 60_000, stdio: 'ignore' }).status === 0,
    run: (command, args) => spawnSync(command, args, { stdio: 'inherit' }).status === 0,
    debianRoot: existsSync('/etc/debian_version') && process.getuid?.() === 0,
    say: (line) => console.log(line),
  };
}

/**
 * Gives the path of a Chromium that starts; installs one when there is none: Playwright's, else Debian's.
 *
 * @param {InstallWorld} [world]
 * @returns {string}
 * @throws {Error} that says what to do when none can be found or installed
 */
export function ensureBrowser(world = thisMachine()) {
  const { say, run } = world;
  const playwright = () => toolPath('@playwright/test', 'playwright');
  const found = world.find();
  if (found && world.starts(found.path)) return found.path;
  if (found?.source === 'CHROMIUM_PATH') {
    throw new Error(`CHROMIUM_PATH is ${found.path}, which does not start: run it by hand to see why, or unset it.`);
  }

  if (!found) {
    say('No Chromium found: installing the one that Playwright brings.');
    run(process.execPath, [playwright(), 'install', 'chromium']);
  }
  const installed = world.find();
  if (installed && world.starts(installed.path)) return installed.path;
  if (world.debianRoot) {
    if (installed) {
      say(`${installed.path} does not start: installing the system libraries that it needs.`);
      run(process.execPath, [playwright(), 'install-deps', 'chromium']);
      if (world.starts(installed.path)) return installed.path;
    } else {
      say("Installing the system's Chromium instead.");
      if (run('apt-get', ['update'])) run('apt-get', ['install', '-y', 'chromium']);
      const system = world.find();
      if (system && world.starts(system.path)) return system.path;
    }
  }
  throw new Error(
    installed
      ? `The browser ${installed.path} does not start. Its system libraries may be missing: run "npx playwright install-deps chromium" as root, or set CHROMIUM_PATH to another Chromium.`
      : 'No Chromium could be found or installed. Install Chromium or Google Chrome and run the tests again, or set CHROMIUM_PATH to the path of one.',
  );
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    console.log(ensureBrowser());
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exitCode = 1;
  }
}
