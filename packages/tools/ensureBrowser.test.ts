import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { ensureBrowser } from './ensureBrowser.mjs';
import { root } from './root.mjs';

/** A machine on which `installs` says what a command brings, and `broken` what does not start. */
function machine(options: { there?: string; installs?: Record<string, string>; broken?: string[]; root?: boolean }) {
  let there = options.there ?? '';
  const broken = new Set(options.broken);
  const commands: string[] = [];
  return {
    commands,
    find: () => (there ? { path: there, source: 'system' as const } : null),
    starts: (path: string) => !broken.has(path),
    run(command: string, args: string[]) {
      const line = [command === process.execPath ? 'playwright' : command, ...args.filter((arg) => !arg.includes('/'))];
      const text = line.join(' ');
      commands.push(text);
      if (text === 'playwright install-deps chromium') broken.clear();
      there ||= options.installs?.[text] ?? '';
      return true;
    },
    debianRoot: options.root ?? false,
    say: () => {},
  };
}

it('installs nothing when a browser starts', () => {
  const world = machine({ there: '/usr/bin/chromium' });
  expect(ensureBrowser(world)).toBe('/usr/bin/chromium');
  expect(world.commands).toEqual([]);
});

it("installs Playwright's, and Debian's only when that fails", () => {
  const playwright = machine({ installs: { 'playwright install chromium': '/cache/chrome' }, root: true });
  expect(ensureBrowser(playwright)).toBe('/cache/chrome');
  expect(playwright.commands).toEqual(['playwright install chromium']);

  const debian = machine({ installs: { 'apt-get install -y chromium': '/usr/bin/chromium' }, root: true });
  expect(ensureBrowser(debian)).toBe('/usr/bin/chromium');
  expect(debian.commands).toEqual(['playwright install chromium', 'apt-get update', 'apt-get install -y chromium']);
});

it('mends missing libraries as root', () => {
  const world = machine({ there: '/cache/chrome', broken: ['/cache/chrome'], root: true });
  expect(ensureBrowser(world)).toBe('/cache/chrome');
  expect(world.commands).toEqual(['playwright install-deps chromium']);
});

it('says what to do when there is no way', () => {
  expect(() => ensureBrowser(machine({}))).toThrow(/Install Chromium or Google Chrome.*CHROMIUM_PATH/);
  expect(() => ensureBrowser(machine({ there: '/cache/chrome', broken: ['/cache/chrome'] }))).toThrow(/install-deps/);
});

it('as a script ends with one sentence and no trace', () => {
  const env = { ...process.env, CHROMIUM_PATH: join(root, 'no browser') };
  const script = join(root, 'packages/tools/ensureBrowser.mjs');
  const { status, stdout, stderr } = spawnSync(process.execPath, [script], { env, encoding: 'utf8' });
  expect([status, stdout]).toEqual([1, '']);
  expect(stderr).toMatch(/^CHROMIUM_PATH is .*no browser, which does not exist: correct the variable or unset it\.\n$/);
});
