import { expect, test } from 'vitest';
import { MeshStandardMaterial } from 'three';
import { OutputMaterial, PassMaterial } from '../gpu/PassMaterial';
import { createTwin, type TwinContext } from '../materials/createTwin';
import { MicroShaderRegistry } from '../microshaders';
import type { TwinKind } from '../materials/TwinKind';

const registry = new MicroShaderRegistry();
registry.add({
  name: 'depthOnly',
  dependencies: [],
  header: 'uniform highp sampler2D depths;',
  main: 'float depth = 1.0;',
});
registry.add({ name: 'place', dependencies: [], header: '', main: 'gl_Position = vec4(0.0);' });

/** Precision statements of a shader, and the text after each. */
const statements = (shader: string): string[] =>
  shader.split('\n').filter((line) => /^(precision \w+ (float|int);|#if|#el|#endif|uniform|void main)/.test(line));

test('a renderer of medium precision: what a twin gets of Farol is in full precision, the host around it is not', () => {
  const kind = {
    key: 'kind',
    chunks: () => ['depthOnly'],
    patch(shader, _source, header) {
      shader.fragmentShader = `${header}${shader.fragmentShader}`;
    },
  } satisfies TwinKind;
  const context = { uniforms: {}, microshaders: registry, refuse() {} } as TwinContext;
  const shader = { vertexShader: '', fragmentShader: 'void main() {}', uniforms: {}, defines: {} };
  createTwin(new MeshStandardMaterial(), kind, context).onBeforeCompile(shader as never, {} as never);
  expect(statements(shader.fragmentShader)).toEqual([
    'precision highp float;',
    'precision highp int;',
    'uniform highp sampler2D depths;',
    '#ifdef MEDIUM_PRECISION',
    'precision mediump float;',
    '#elif defined( LOW_PRECISION )',
    'precision lowp float;',
    '#endif',
    'void main() {}',
  ]);
});

test.each([PassMaterial, OutputMaterial])('a full-screen pass computes in full precision: %o', (Material) => {
  const material = new Material(registry, { name: 'pass', vertex: ['place'], fragment: ['depthOnly'], uniforms: {} });
  expect(statements(material.fragmentShader).slice(0, 2)).toEqual(['precision highp float;', 'precision highp int;']);
});
