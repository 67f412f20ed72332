import { existsSync, readdirSync } from 'node:fs';
import { delimiter, join } from 'node:path';

/**
 * @typedef {object} OtherWorld what the search may see of the machine; tests give a made-up one
 * @property {Record<string, string | undefined>} env
 * @property {string} platform as `process.platform`
 * @property {(path: string) => boolean} exists
 * @property {(folder: string) => readonly string[]} list names in a folder, none when it is not there
 *
 * @typedef {object} OtherBrowsers paths; null where one is missing
 * @property {string | null} firefox
 * @property {{ driver: string, browser: string } | null} webkit
 * @property {string | null} xvfb X server in memory, needed by Firefox for WebGL; null where there is a screen
 * @property {readonly string[]} missing lines, each with a browser that is missing and how to install it
 */

/** @returns {OtherWorld} the machine that this process runs on */
const thisMachine = () => ({
  env: process.env,
  platform: process.platform,
  exists: existsSync,
  list: (folder) => (existsSync(folder) ? readdirSync(folder) : []),
});

const firefoxes = {
  darwin: ['/Applications/Firefox.app/Contents/MacOS/firefox'],
  win32: ['C:\\Program Files\\Mozilla Firefox\\firefox.exe'],
};

/**
 * Looks for Firefox (FIREFOX_PATH, then the system's) and for WebKitGTK with its WebDriver. Installs nothing.
 *
 * @param {OtherWorld} [world]
 * @returns {OtherBrowsers}
 * @throws {Error} when FIREFOX_PATH names a file that does not exist
 */
export function findOtherBrowsers(world = thisMachine()) {
  const { env, platform, exists, list } = world;
  const inPath = (/** @type {string[]} */ ...names) =>
    names
      .flatMap((name) => (env.PATH ?? '').split(delimiter).map((folder) => join(folder, name)))
      .find((path) => exists(path)) ?? null;
  if (env.FIREFOX_PATH && !exists(env.FIREFOX_PATH))
    throw new Error(`FIREFOX_PATH is ${env.FIREFOX_PATH}, which does not exist: correct the variable or unset it.`);
  const isLinux = platform === 'linux';
  const needsScreen = isLinux && !env.DISPLAY && !env.WAYLAND_DISPLAY;
  const xvfb = needsScreen ? inPath('Xvfb') : null;
  const usual = firefoxes[/** @type {keyof typeof firefoxes} */ (platform)] ?? [];
  const firefox = env.FIREFOX_PATH || inPath('firefox-esr', 'firefox') || (usual.find(exists) ?? null);
  const driver = isLinux ? inPath('WebKitWebDriver') : null;
  const browser = ['/usr/lib', '/usr/libexec']
    .flatMap((top) => [top, ...list(top).map((name) => join(top, name))])
    .flatMap((folder) => ['webkit2gtk-4.1', 'webkitgtk-6.0'].map((name) => join(folder, name, 'MiniBrowser')))
    .find(exists);
  const missing = [];
  if (!firefox) missing.push('No Firefox: apt-get install firefox-esr, or set FIREFOX_PATH to one.');
  if (!isLinux) missing.push('No WebKit: it is driven on Linux alone, as WebKitGTK.');
  else if (!driver || !browser) missing.push('No WebKit: apt-get install webkit2gtk-driver.');
  if (!needsScreen || xvfb) return { firefox, webkit: driver && browser ? { driver, browser } : null, xvfb, missing };
  return { firefox: null, webkit: null, xvfb, missing: [...missing, 'No screen: apt-get install xvfb.'] };
}
