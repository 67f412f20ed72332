import { addMicroShaders } from '@farol/renderer/authoring';
import { MicroShaderRegistry } from '@farol/renderer/microshaders';
import { expect, it } from 'vitest';
import { Scene } from '../core/Scene';
import { MicroShaderOverrides } from './MicroShaderOverrides';

function made() {
  const parent = new MicroShaderRegistry<string>();
  parent.loadGLSL('a', 'float a;');
  parent.loadGLSL('b', '#include "a"\nfloat b;');
  const registry = new MicroShaderRegistry<string>(parent, {
    compiler: {
      compile: ({ fragmentShader }) => {
        if (fragmentShader.includes('BROKEN')) throw new Error('broken');
        return fragmentShader;
      },
    },
  });
  const shader = registry.getShader('s', [], ['b']);
  const scene = new Scene();
  // stands for a renderer's registry, which would need WebGL
  const overrides = new MicroShaderOverrides(registry as never);
  const apply = () => overrides.apply(scene.microShaders.texts).map(({ name, error }) => `${name}: ${error.message}`);
  return { registry, shader, scene, apply, overrides };
}

it("brings a scene's microshaders in, whatever their order, and takes them out again", () => {
  const { registry, shader, scene, apply } = made();
  const before = shader.program;
  scene.microShaders.set('b', '#include "own/two"\nfloat b2;');
  scene.microShaders.set('own/one', 'float one;');
  scene.microShaders.set('own/two', '#include "own/one"\nfloat two;');
  expect(apply()).toEqual([]);
  expect(shader.program).toMatch(/one;[^]*two;[^]*b2;/);
  scene.microShaders.set('own/one', 'float uno;');
  expect(apply()).toEqual([]);
  expect(shader.program).toContain('uno');
  for (const name of ['own/one', 'own/two', 'b']) scene.microShaders.set(name, null);
  expect(apply()).toEqual([]);
  expect(shader.program).toBe(before);
  expect(registry.names()).toEqual(['a', 'b']);
});

it('names what is refused, and leaves the last good text in use', () => {
  const { shader, scene, apply } = made();
  scene.microShaders.set('b', 'float good;');
  expect(apply()).toEqual([]);
  scene.microShaders.set('b', 'BROKEN');
  scene.microShaders.set('a', 'float fine;');
  expect(apply()).toEqual(['b: broken']);
  expect(shader.program).toContain('good');
  scene.microShaders.set('b', null);
  expect(apply()).toEqual([]);
  expect(shader.program).toMatch(/fine;[^]*float b;/);
});

it('puts a chunk back that is not built in, such as those of effects', () => {
  const { registry, scene, apply, overrides } = made();
  registry.loadGLSL('shadow', 'float shadow;');
  scene.microShaders.set('shadow', 'float other;');
  scene.microShaders.set('own', 'float own;');
  expect(apply()).toEqual([]);
  expect(registry.get('shadow')!.header).toBe('float other;');
  expect(overrides.originalOf('shadow')!.header).toBe('float shadow;');
  expect(overrides.originalOf('own')).toBeUndefined();
  for (const name of ['shadow', 'own']) scene.microShaders.set(name, null);
  expect(apply()).toEqual([]);
  expect(registry.get('shadow')!.header).toBe('float shadow;');
  expect(registry.has('own')).toBe(false);
});

it('keeps a text of a chunk whose code comes later, and gives the chunk back', () => {
  const { registry, scene, apply, overrides } = made();
  scene.microShaders.set('lightLoopOne', 'float other;');
  expect(apply()).toEqual([]);
  addMicroShaders(registry as never, 'technique forward', { lightLoopOne: 'float one;' });
  expect(registry.get('lightLoopOne')!.header).toBe('float other;');
  expect(overrides.originalOf('lightLoopOne')!.header).toBe('float one;');
  scene.microShaders.set('lightLoopOne', null);
  expect(apply()).toEqual([]);
  expect(registry.get('lightLoopOne')!.header).toBe('float one;');
});
