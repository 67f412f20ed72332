import { expect, test } from 'vitest';
import { findOtherBrowsers } from './findOtherBrowsers.mjs';

const lib = '/usr/lib/x86_64-linux-gnu';
const all = ['/usr/bin/firefox-esr', '/usr/bin/WebKitWebDriver', '/usr/bin/Xvfb', `${lib}/webkit2gtk-4.1/MiniBrowser`];

/** A machine with these files. */
const world = (files: readonly string[], env: Record<string, string> = {}, platform = 'linux') => ({
  env: { PATH: '/usr/bin', ...env },
  platform,
  exists: (path: string) => files.includes(path),
  list: (folder: string) => (folder === '/usr/lib' ? ['x86_64-linux-gnu'] : []),
});

test('finds both, and a screen in memory where there is none', () => {
  const webkit = { driver: all[1], browser: all[3] };
  expect(findOtherBrowsers(world(all))).toEqual({ firefox: all[0], webkit, xvfb: all[2], missing: [] });
  expect(findOtherBrowsers(world(all, { DISPLAY: ':0' })).xvfb).toBeNull();
});

test('says how what is missing is installed', () => {
  const { firefox, webkit, missing } = findOtherBrowsers(world(all.slice(2)));
  expect([firefox, webkit]).toEqual([null, null]);
  expect(missing.join()).toMatch(/apt-get install firefox-esr.*apt-get install webkit2gtk-driver/);
  const without = findOtherBrowsers(world(all.filter((path) => !path.endsWith('Xvfb'))));
  expect(without).toMatchObject({ firefox: null, webkit: null, missing: [expect.stringContaining('xvfb')] });
});

test('elsewhere than on Linux, Firefox alone', () => {
  const mac = '/Applications/Firefox.app/Contents/MacOS/firefox';
  expect(findOtherBrowsers(world([mac], {}, 'darwin'))).toMatchObject({ firefox: mac, webkit: null, xvfb: null });
});

test('takes FIREFOX_PATH, and refuses one that is not there', () => {
  expect(findOtherBrowsers(world([...all, '/opt/fx'], { FIREFOX_PATH: '/opt/fx' })).firefox).toBe('/opt/fx');
  expect(() => findOtherBrowsers(world(all, { FIREFOX_PATH: '/gone' }))).toThrow(/FIREFOX_PATH is \/gone/);
});
