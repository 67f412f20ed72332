import { describe, expect, it } from 'vitest';
import { EXTENSION, FLOATS_PER_RECORD, extensionRecord, LIGHT, lightRecord } from '../lights/lightRecord';
import { texelOffsets } from '../lights/recordLayout';
import { recordGetters } from './recordGetters';

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
  });

  it('go on in the next record', () => {
    const layout = Object.fromEntries([0, 1, 2, 3, 4].map((i) => [`t${i}`, { [`v${i}`]: 'x' }]));
    expect(recordGetters('mask', layout)).toContain(
      'float farol_maskV4(int record) { return farol_lightTexel(record + 1, 0).x; }',
    );
  });

  it('lie where TypeScript writes, in one record', () => {
    expect(texelOffsets(lightRecord)).toEqual({ sphere: 0, emission: 4, cone: 8, details: 12 });
    for (const [offsets, layout] of [[LIGHT, lightRecord] as const, [EXTENSION, extensionRecord] as const]) {
      expect(Object.keys(offsets)).toEqual(Object.keys(layout));
      expect(Math.max(...Object.values(offsets))).toBeLessThan(FLOATS_PER_RECORD);
    }
  });
});
