import { describe, expect, it } from 'vitest';
import { addMicroShaders } from './addMicroShaders';
import { MicroShaderRegistry } from './MicroShaderRegistry';

const parent = new MicroShaderRegistry();
parent.loadGLSL('built', 'float built;');

describe('addMicroShaders', () => {
  it('adds each chunk once, whoever brings it, and keeps a live edit', () => {
    const registry = new MicroShaderRegistry(parent);
    addMicroShaders(registry, 'SMAA', { a: 'float a;', b: 'float b;' });
    registry.replace('a', 'float edited;');
    addMicroShaders(registry, 'TAA', { a: 'float a;', c: 'float c;' });
    expect(registry.names()).toEqual(['built', 'a', 'b', 'c']);
    expect(registry.get('a')!.header).toBe('float edited;');
  });

  it('leaves an edit that was there first in use, and puts the chunk in its place once the edit is taken back', () => {
    const registry = new MicroShaderRegistry(parent);
    registry.loadGLSL('a', 'float edited;', true);
    expect(registry.original('a')).toBeUndefined();
    expect(registry.textKey(['a'])).not.toBe('');
    addMicroShaders(registry, 'SMAA', { a: 'float a;', b: 'float b;' });
    addMicroShaders(registry, 'TAA', { a: 'float a;' });
    expect(registry.get('a')!.header).toBe('float edited;');
    expect(registry.original('a')!.header).toBe('float a;');
    registry.replace('a', 'float again;');
    registry.remove('a');
    expect(registry.get('a')!.header).toBe('float a;');
    expect(registry.original('a')).toBeUndefined();
    expect(() => registry.remove('a')).toThrow(/was not replaced/);
    expect(() => addMicroShaders(registry, 'my effect', { a: 'float other;' })).toThrow('differs from that of SMAA;');
  });

  it('names both who bring different texts of one name, and adds none', () => {
    const registry = new MicroShaderRegistry(parent);
    addMicroShaders(registry, 'SMAA', { a: 'float a;' });
    expect(() => addMicroShaders(registry, 'my effect', { b: '', a: 'float other;' })).toThrow(
      'Microshader "a" of my effect differs from that of SMAA; give it another name.',
    );
    expect(() => addMicroShaders(registry, 'my effect', { built: 'float other;' })).toThrow(
      'differs from that of Farol;',
    );
    expect(registry.names()).toEqual(['built', 'a']);
  });

  it('lets two renderers have chunks of one name', () => {
    addMicroShaders(new MicroShaderRegistry(), 'SMAA', { a: 'float a;' });
    expect(() => addMicroShaders(new MicroShaderRegistry(), 'TAA', { a: 'float b;' })).not.toThrow();
  });
});
