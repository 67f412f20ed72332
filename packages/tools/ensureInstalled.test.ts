import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync } from 'vite';
import { expect, it } from 'vitest';
import { needsInstall, placeProblem } from './ensureInstalled.mjs';

it('installs in a fresh clone and after the lock file changed, not otherwise', () => {
  expect(needsInstall(null, 10)).toBe(true);
  expect(needsInstall(10, 11)).toBe(true);
  expect(needsInstall(11, 10)).toBe(false);
});

const here = (version: string, folder = '/home/me/farol', closed = ''): string | null =>
  placeProblem(version, folder, (path) => path !== closed);

it('runs on the versions of Node that README names, and says so on others', () => {
  for (const version of ['20.19.0', '20.20.2', '22.12.0', '23.0.0', '26.1.0'])
    expect(here(version), version).toBeNull();
  for (const version of ['18.20.0', '20.10.0', '20.18.3', '21.7.0', '22.11.0'])
    expect(here(version), version).toMatch(
      /^Farol needs Node 20\.19 .* and this is Node [\d.]+: install a newer one\.$/,
    );
});

it('names a path that Vite does not serve, and a folder that cannot be written, with the mend', () => {
  expect(here('22.12.0', '/home/me/c#/farol')).toMatch(
    /^Farol lies in \/home\/me\/c#\/farol.* with a '#' .*rename or move/,
  );
  expect(here('22.12.0', '/usr/farol', join('/usr/farol', 'node_modules'))).toMatch(
    /^Farol cannot write to .*node_modules, .*allow it, or copy/,
  );
});

/** Packages that a script needs before its first line runs. */
function packagesOf(file: string, seen = new Set<string>()): string[] {
  if (seen.has(file)) return [];
  seen.add(file);
  const { module } = parseSync(file, readFileSync(file, 'utf8'));
  return module.staticImports.flatMap(({ moduleRequest: { value } }) => {
    if (value.startsWith('.')) return packagesOf(join(dirname(file), value), seen);
    return value.startsWith('node:') ? [] : [value];
  });
}

it('no command needs a package before it could have installed it', () => {
  const folder = fileURLToPath(new URL('.', import.meta.url));
  const commands = readdirSync(folder).filter(
    (name) =>
      name.endsWith('.mjs') &&
      /^ +ensureInstalled\(\);|^ensureInstalled\(\);/m.test(readFileSync(join(folder, name), 'utf8')),
  );
  expect(commands).toContain('start.mjs');
  expect(Object.fromEntries(commands.map((name) => [name, packagesOf(join(folder, name))]))).toEqual(
    Object.fromEntries(commands.map((name) => [name, []])),
  );
});
