import type { WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { MicroShaderRegistry } from '../microshaders/MicroShaderRegistry';
import type { ShaderSource } from '../microshaders/Shader';
import { checkLiveEdit } from './checkLiveEdit';

/** A context with one program that refuses to compile sources with certain words. */
function contextWith(fragment: string, refused: RegExp) {
  const tried: string[] = [];
  let source = '';
  const gl = {
    getShaderSource: (shader: string) => shader,
    createShader: () => ({}),
    shaderSource: (_shader: unknown, text: string) => tried.push((source = text)),
    compileShader: () => {},
    getShaderParameter: () => !refused.test(source.replaceAll(/^\/\/.*$/gm, '')),
    getShaderInfoLog: () => '',
    deleteShader: () => {},
  };
  const program = { name: 'Light', vertexShader: '', fragmentShader: fragment };
  const webgl = { getContext: () => gl, info: { programs: [program] } } as unknown as WebGLRenderer;
  return { webgl, tried };
}

test('a program whose material names things otherwise is tried with these names', () => {
  const compiler = { compile: (source: ShaderSource) => source, release: () => {} };
  const registry = new MicroShaderRegistry<ShaderSource>(null, { compiler });
  registry.loadGLSL('falloff', 'float falloff() { return gl_FragCoord.x; }');
  registry.loadGLSL('particle', '#include "falloff"\n//# main\nvec2 texel = TEXEL.xy;\ngl_FragCoord.xy = texel;');
  const rewritten = registry
    .compose([], ['particle'])
    .fragmentShader.replaceAll('gl_FragCoord', 'coordinate')
    .replaceAll('TEXEL', 'gl_FragCoord');
  const names = '// names gl_FragCoord=coordinate TEXEL=gl_FragCoord\nvec4 coordinate;\n';
  const { webgl, tried } = contextWith(names + rewritten, /TEXEL|gl_FragCoord\.xy =/);
  registry.addCheck((changed) => checkLiveEdit(webgl, registry, changed));
  registry.replace('falloff', 'float falloff() { return 2.0 * gl_FragCoord.x; }');
  expect(tried).toHaveLength(1);
  expect(tried[0]).toContain('return 2.0 * coordinate.x;');
  expect(tried[0]).toContain('vec2 texel = gl_FragCoord.xy;');
  expect(tried[0]).toContain('coordinate.xy = texel;');
});

test('microshaders that stand after one whose new text needs them are tried before it', () => {
  const registry = new MicroShaderRegistry<ShaderSource>();
  registry.loadGLSL('falloff', 'float falloff() { return 1.0; }');
  registry.loadGLSL('pixel', 'vec2 pixel() { return gl_FragCoord.xy; }');
  registry.loadGLSL('light', '#include "falloff"\n#include "pixel"\n//# main\ngl_FragColor = vec4(falloff());');
  const { webgl, tried } = contextWith(registry.compose([], ['light']).fragmentShader, /^$/);
  registry.addCheck((changed) => checkLiveEdit(webgl, registry, changed));
  registry.replace('falloff', '#include "pixel"\nfloat falloff() { return pixel().x; }');
  expect(tried).toEqual([registry.compose([], ['light']).fragmentShader]);
});
