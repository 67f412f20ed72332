import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { findClaims } from '../findClaims';
import { MicroShaderRegistry } from '../MicroShaderRegistry';
import { builtinMicroShaders } from './index';

const folder = new URL('.', import.meta.url);
const files = readdirSync(folder).filter((name) => name.endsWith('.glsl'));

describe('the built-in microshaders', () => {
  it('are all in the table, and resolve', () => {
    const registry = new MicroShaderRegistry();
    registry.add(builtinMicroShaders);
    expect(registry.names()).toEqual(expect.arrayContaining(files.map((file) => file.replace('.glsl', ''))));
    for (const name of registry.names()) expect(registry.header([name]).split(`// <${name}>\n`)).toHaveLength(2);
  });

  it.each(files)('%s opens with what it is for and its source, and its claims can be read', (file) => {
    const text = readFileSync(new URL(file, folder), 'utf8');
    const [purpose, source] = text.split('\n');
    expect(purpose).toMatch(/^\/\/ \S.*\.$/);
    expect(source).toMatch(/^\/\/ \S/);
    expect(() => findClaims(text)).not.toThrow();
  });
});
