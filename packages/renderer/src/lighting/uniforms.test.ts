import { describe, expect, it } from 'vitest';
import { builtinMicroShaders } from '../authoring/builtinMicroShaders';
import { gbufferUniforms } from '../passes/gbuffer/gbufferUniforms';
import { unprojectUniforms } from '../gpu/unprojectUniforms';
import { microShaders as areas } from './area-lights';
import { microShaders as multipass } from '../techniques/multipass';
import { microShaders as shadows } from '../shadows';
import { lightUniforms } from './lightUniforms';
import { gridUniforms } from './lists/gridUniforms';
import { tileUniforms } from './lists/tileUniforms';
import { maskUniforms } from './maskUniforms';

const texts = new Map([
  ...builtinMicroShaders.map(({ name, header }) => [name, header] as const),
  ...Object.entries({ ...areas, ...multipass, ...shadows }),
]);

/** Names of the uniforms that microshaders declare themselves. */
function declared(names: readonly string[]): Set<string> {
  const found = names.flatMap((name) => [...texts.get(name)!.matchAll(/^uniform (?:\w+ )?\w+ (\w+)(?:\[\w+\])?;/gm)]);
  return new Set(found.map(([, name]) => name));
}

describe('the uniforms of a microshader', () => {
  it.each([
    ['unprojectUniforms', unprojectUniforms(), ['unproject', 'depthMode']],
    [
      'lightUniforms',
      lightUniforms(new Float32Array(12)),
      ['lightRecord', 'lightTable', 'fewLights', 'ambientLight', 'lightLoopOne', 'areaForms', 'areaLightOn'],
    ],
    ['tileUniforms', tileUniforms(), ['lightTiles', 'lightTileLists', 'viewport']],
    [
      'gridUniforms and maskUniforms',
      { ...gridUniforms(), ...maskUniforms() },
      [
        'lightLoopClustered',
        'imageSamplers',
        'lightImage',
        'targetPixel',
        'lightShadow',
        'shadowMask',
        'lightMaskLayers',
      ],
    ],
    [
      'gbufferUniforms',
      gbufferUniforms(),
      ['gbufferTextures', 'gbufferRead', 'unproject', 'depthMode', 'viewport', 'volumeLighting'],
    ],
  ])('are those of %s', (_, uniforms, names) => {
    expect(new Set(Object.keys(uniforms))).toEqual(declared(names));
  });
});
