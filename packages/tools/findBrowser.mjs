import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { delimiter, join } from 'node:path';

/**
 * @typedef {object} BrowserWorld what the search may see of the machine; tests give a made-up one
 * @property {Record<string, string | undefined>} env
 * @property {string} platform as `process.platform`
 * @property {(path: string) => boolean} exists
 * @property {() => string | null} playwrightPath where Playwright would keep its own Chromium, null if unknown
 *
 * @typedef {{ path: string, source: 'CHROMIUM_PATH' | 'playwright' | 'system' }} FoundBrowser
 */

const linuxNames = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'microsoft-edge'];

const macPaths = [
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge',
];

const windowsPaths = ['Google\\Chrome\\Application\\chrome.exe', 'Microsoft\\Edge\\Application\\msedge.exe'];

/** @returns {BrowserWorld} the machine that this process runs on */
function thisMachine() {
  return {
    env: process.env,
    platform: process.platform,
    exists: existsSync,
    playwrightPath() {
      try {
        return createRequire(import.meta.url)('playwright-core').chromium.executablePath() || null;
      } catch {
        return null; // Playwright is not installed yet, or has no browser for this platform
      }
    },
  };
}

/**
 * Looks for a Chromium: the environment variable CHROMIUM_PATH, then Playwright's own, then the system's Chromium,
 * Chrome or Edge. Installs nothing.
 *
 * @param {BrowserWorld} [world]
 * @returns {FoundBrowser | null}
 * @throws {Error} when CHROMIUM_PATH names a file that does not exist
 */
export function findBrowser(world = thisMachine()) {
  const { env, exists } = world;
  if (env.CHROMIUM_PATH) {
    if (!exists(env.CHROMIUM_PATH)) {
      throw new Error(`CHROMIUM_PATH is ${env.CHROMIUM_PATH}, which does not exist: correct the variable or unset it.`);
    }
    return { path: env.CHROMIUM_PATH, source: 'CHROMIUM_PATH' };
  }
  const own = world.playwrightPath();
  if (own && exists(own)) return { path: own, source: 'playwright' };
  const system = systemPaths(world).find(exists);
  return system ? { path: system, source: 'system' } : null;
}

/** @param {BrowserWorld} world */
function systemPaths({ env, platform }) {
  if (platform === 'darwin') return macPaths;
  if (platform === 'win32') {
    const roots = [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA].filter((root) => root !== undefined);
    return windowsPaths.flatMap((path) => roots.map((root) => `${root}\\${path}`));
  }
  const folders = (env.PATH ?? '').split(delimiter).filter(Boolean);
  return linuxNames.flatMap((name) => folders.map((folder) => join(folder, name)));
}
