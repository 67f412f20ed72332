import { describe, expect, it } from 'vitest';
import { findClaims } from './findClaims';
import { MicroShaderRegistry } from '../microshaders/MicroShaderRegistry';
import { builtinMicroShaders } from './builtinMicroShaders';

const files = import.meta.glob<string>(
  [
    '../{gbuffer,gpu,lighting}/**/*.glsl',
    '../passes/output/*.glsl',
    '../techniques/light-{lists,volumes}/*.glsl',
    '!../lighting/area-lights/**',
  ],
  {
    query: '?raw',
    import: 'default',
    eager: true,
  },
);

const folders = import.meta.glob<Record<string, string>>('../**/chunks.ts', { eager: true });

describe('the built-in microshaders', () => {
  it('have a name each over all folders, those that are fetched late too', () => {
    const names = Object.values(folders).flatMap((chunks) => Object.keys(chunks));
    expect(names.length).toBeGreaterThan(50);
    expect(names.filter((name, i) => names.indexOf(name) !== i)).toEqual([]);
    expect(names).toEqual(expect.arrayContaining(builtinMicroShaders.map(({ name }) => name)));
  });

  it('are all in the table, and resolve', () => {
    const registry = new MicroShaderRegistry();
    registry.add(builtinMicroShaders);
    expect(registry.names()).toEqual(
      expect.arrayContaining(Object.keys(files).map((file) => file.slice(file.lastIndexOf('/') + 1, -'.glsl'.length))),
    );
    for (const name of registry.names()) expect(registry.header([name]).split(`// <${name}>\n`)).toHaveLength(2);
  });

  it.each(Object.keys(files))('%s opens with what it is for and its source, and its claims can be read', (file) => {
    expect(files[file]).toMatch(/^(\/\/ \S.*\n)*?\/\/ \S.*\.\n\/\/ \S/);
    expect(() => findClaims(files[file])).not.toThrow();
  });
});
