import { describe, expect, it } from 'vitest';
import {
  attenuationKinds,
  EXTENSION,
  FLOATS_PER_RECORD,
  extensionRecord,
  LIGHT,
  lightRecord,
  RECORDS_PER_ROW,
  TEXELS_PER_RECORD,
} from '../lights/lightRecord';
import { texelOffsets } from '../lights/recordLayout';
import { recordGetters } from './recordGetters';

const sources = import.meta.glob<string>(['../**/*.glsl', '!./lightRecord.glsl'], {
  query: '?raw',
  import: 'default',
  eager: true,
});

describe('the getters of a record', () => {
  it('read a value of a record by one fetch, or of a texel that was fetched', () => {
    const layout = { first: { a: 'xyz', b: 'w' }, second: { isC: ['bool', 't.w >= 0.0'], d: ['float', 't.x + t.y'] } };
    expect(recordGetters('light', layout as never).split('\n')).toEqual([
      'vec4 farol_lightFirst(int record) { return farol_lightTexel(record, 0); }',
      'vec3 farol_lightA(vec4 t) { return t.xyz; }',
      'vec3 farol_lightA(int record) { return farol_lightTexel(record, 0).xyz; }',
      'float farol_lightB(vec4 t) { return t.w; }',
      'float farol_lightB(int record) { return farol_lightTexel(record, 0).w; }',
      'vec4 farol_lightSecond(int record) { return farol_lightTexel(record, 1); }',
      'bool farol_lightIsC(vec4 t) { return t.w >= 0.0; }',
      'bool farol_lightIsC(int record) { return farol_lightTexel(record, 1).w >= 0.0; }',
      // of two numbers, so that nothing is fetched twice
      'float farol_lightD(vec4 t) { return t.x + t.y; }',
    ]);
    expect(recordGetters('light', layout as never, ['first'])).toContain(
      'float farol_lightB(int record) { return farol_firstTexel(record).w; }',
    );
  });

  it('tell the kinds of attenuation by their numbers', () => {
    const { isNearFar, isPolynomial } = extensionRecord.falloff;
    const { nearFar, polynomial } = attenuationKinds;
    expect([isNearFar[1], isPolynomial[1]]).toEqual([`t.w == ${nearFar}.0`, `t.w == ${polynomial}.0`]);
  });

  it('go on in the next record', () => {
    const layout = Object.fromEntries([0, 1, 2, 3, 4].map((i) => [`t${i}`, { [`v${i}`]: 'x' }]));
    expect(recordGetters('mask', layout)).toContain(
      'float farol_maskV4(int record) { return farol_lightTexel(record + 1, 0).x; }',
    );
  });

  // after a change of the tables: npx vitest run --config packages/vitest.config.ts recordGetters -u
  it('make lightRecord.glsl: those that a shader asks for', async () => {
    const shaders = Object.values(sources).join('\n');
    const getters =
      `${recordGetters('light', lightRecord, ['sphere', 'emission'])}\n${recordGetters('extension', extensionRecord)}`.split(
        '\n',
      );
    // shaders call a texel by its name in the table
    const texels = new Set([...Object.keys(lightRecord), ...Object.keys(extensionRecord)]);
    const used = getters.filter((line) => {
      const [, name, kind] = /(farol_\w+)\((\w+)/.exec(line)!;
      const calls = [...shaders.matchAll(new RegExp(`\\b${name}\\((\\w+)`, 'g'))];
      return calls.some(([, argument]) => texels.has(argument) === (kind === 'vec4'));
    });
    await expect(`// Reads the records of the light table.
// Farol; made from the tables in lights/lightRecord.ts by lighting/recordGetters.test.ts
uniform highp sampler2D farol_lightTable;
vec4 farol_lightTexel(const in int record, const in int texel) {
  ivec2 at = ivec2((record & ${RECORDS_PER_ROW - 1}) * ${TEXELS_PER_RECORD} + texel, record >> ${Math.log2(RECORDS_PER_ROW)});
  return texelFetch(farol_lightTable, at, 0);
}
#ifdef FAROL_FEW_LIGHTS
vec4 farol_sphereTexel(const in int record) {
  if (record >= farol_fewLights) return farol_lightTexel(record, ${LIGHT.sphere / 4});
  return farol_few(farol_fewSphere0, farol_fewSphere1, record);
}
vec4 farol_emissionTexel(const in int record) {
  if (record >= farol_fewLights) return farol_lightTexel(record, ${LIGHT.emission / 4});
  return farol_few(farol_fewEmission0, farol_fewEmission1, record);
}
#else
#define farol_sphereTexel(record) farol_lightTexel(record, ${LIGHT.sphere / 4})
#define farol_emissionTexel(record) farol_lightTexel(record, ${LIGHT.emission / 4})
#endif
${used.join('\n')}
`).toMatchFileSnapshot('./lightRecord.glsl');
  });

  it('lie where TypeScript writes, in one record', () => {
    for (const [offsets, layout] of [[LIGHT, lightRecord] as const, [EXTENSION, extensionRecord] as const]) {
      expect(offsets).toEqual(texelOffsets(layout));
      expect(Math.max(...Object.values(offsets))).toBeLessThan(FLOATS_PER_RECORD);
    }
  });
});
