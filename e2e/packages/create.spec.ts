import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { serveFolder } from '@farol/tools/benchServe';
import { tarballName } from '@farol/tools/packPackages';
import { root } from '@farol/tools/root';
import { runNpm } from '@farol/tools/runNpm';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { installed } from './installed';

interface Locked {
  readonly version?: string;
  readonly dependencies?: Readonly<Record<string, string>>;
  readonly optionalDependencies?: Readonly<Record<string, string>>;
}

/**
 * Lock file of a project: the repository's own entries of all that the project needs besides Farol. npm finds these in its
 * cache by their checksums, since the repository was installed from there, and needs no registry.
 */
function lockFile(manifest: Record<'dependencies' | 'devDependencies', Record<string, string>>): object {
  const locked = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')).packages as Record<string, Locked>;
  const packages: Record<string, unknown> = { '': manifest };
  const add = (name: string, places: readonly string[]): void => {
    const from = places.find((place) => `${place}node_modules/${name}` in locked);
    if (from === undefined) return;
    const at = `${from === 'packages/engine/' ? '' : from}node_modules/${name}`;
    if (at in packages) return;
    const entry = (packages[at] = locked[`${from}node_modules/${name}`]);
    for (const each of Object.keys({ ...entry.dependencies, ...entry.optionalDependencies }))
      add(each, [`${at}/`, ...places]);
  };
  const names = Object.keys({ ...manifest.dependencies, ...manifest.devDependencies });
  for (const name of names.filter((each) => !each.startsWith('@farol/'))) add(name, ['packages/engine/', '']);
  return { lockfileVersion: 3, requires: true, packages };
}

function npm(args: string[], cwd: string): string {
  const { status, stdout, stderr } = runNpm(['--prefer-offline', '--no-audit', '--no-fund', ...args], {
    cwd,
    isQuiet: true,
  });
  if (status !== 0) throw new Error(`npm ${args[0]} failed:\n${stdout}${stderr}`);
  return stdout;
}

/** Whether three tenths of a page's pixels are lit, in more than 200 colours of 16 steps a channel. */
async function isLit(page: Page): Promise<boolean> {
  const png = (await page.screenshot()).toString('base64');
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set<number>();
    let lit = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (Math.max(data[i], data[i + 1], data[i + 2]) > 48) lit++;
      colours.add((data[i] >> 4) * 256 + (data[i + 1] >> 4) * 16 + (data[i + 2] >> 4));
    }
    return (lit * 4) / data.length > 0.3 && colours.size > 200;
  }, png);
}

// JavaScript in the slice: the types of what is created are checked with the repository's own
const cases = [
  { kind: 'plain', language: '--js', tag: '' },
  { kind: 'plain', language: '--ts', tag: ' @verify' },
  { kind: 'react', language: '--js', tag: ' @verify' },
  { kind: 'scene', language: '--ts', tag: ' @verify' },
];

for (const { kind, language, tag } of cases) {
  test(`npm create farol: ${kind} ${language} is installed, built and lit${tag}`, async ({ page, watch }) => {
    const { tarballs, host } = installed();
    const folder = join(host, '..', `created ${kind} ${language}`);
    mkdirSync(folder);
    const version = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')).version as string;
    const creator = join(tarballs, tarballName({ name: 'create-farol', version }));
    const options = ['page', '--kind', kind, language, '--yes', '--no-install', '--tarballs', tarballs];
    // in a cache of its own, which goes with the folder
    const exec = ['exec', '--yes', `--package=${creator}`, `--cache=${join(folder, 'cache')}`];
    expect(npm([...exec, '--', 'create-farol', ...options], folder)).toContain('cd page');

    const project = join(folder, 'page');
    const manifest = JSON.parse(readFileSync(join(project, 'package.json'), 'utf8'));
    writeFileSync(join(project, 'package-lock.json'), JSON.stringify(lockFile(manifest)));
    npm(['install'], project);
    npm(['run', 'build'], project);

    const server = await serveFolder(join(project, 'dist'), { isolated: false });
    try {
      await page.goto(server.url);
      await expect.poll(() => isLit(page), { timeout: 60_000 }).toBe(true);
      watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
      expect(watch.problems).toEqual([]);
    } finally {
      await server.close();
    }
  });
}
