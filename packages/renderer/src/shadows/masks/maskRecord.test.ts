import { expect, test } from 'vitest';
import { cookieShapes, FITS, MASK, maskRecord, RECORDS_PER_MASK, shadowLookups } from './maskLayout';
import { maskRecordChunk } from './maskRecordChunk';
import { packPlace } from './maskRecord';

/** The value of a GLSL getter, which is also JavaScript except for `int()`. */
function read(name: keyof typeof maskRecord.place, z: number): unknown {
  const [, expression] = maskRecord.place[name] as readonly [string, string];
  return new Function('t', `return ${expression.replaceAll('int(', 'Math.trunc(')}`)({ z });
}

test('what is packed in a number comes out again by the getters, and fits a float exactly', () => {
  for (const width of [0, 1, 517, 8192, 32767]) {
    for (const lookup of Object.values(shadowLookups)) {
      for (const shape of Object.values(cookieShapes)) {
        for (const [border, expected] of [
          [0, 1],
          [1, 1],
          [16, 16],
          [128, 128],
        ]) {
          const bits = packPlace(width, lookup, shape, border === 16, border);
          expect(Math.fround(bits)).toBe(bits);
          const values = (['width', 'lookup', 'cookieShape', 'isExtended', 'border'] as const).map((name) =>
            read(name, bits),
          );
          expect(values).toEqual([width, lookup, shape, border === 16, expected]);
        }
      }
    }
  }
});

test('a mask fills its records, and getters look where TypeScript writes', () => {
  expect(RECORDS_PER_MASK).toBe(3);
  expect(MASK).toMatchObject({
    columnX: 0,
    place: 16,
    filtering: 20,
    extent: 24,
    cookie: 32,
    layers: 36,
    firstFit: 40,
  });
  expect(FITS).toEqual([40, 44, 32]);
  for (const line of [
    'vec4 farol_maskColumnW(int record) { return farol_lightTexel(record, 3); }',
    'vec4 farol_maskPlace(int record) { return farol_lightTexel(record + 1, 0); }',
    'vec2 farol_maskLayers(int record) { return farol_lightTexel(record + 2, 1).xy; }',
    'int texel = cascade == 0 ? 2 : cascade == 1 ? 3 : 0;',
    'const int FAROL_LOOKUP_CUBE_PCF = 4;',
  ]) {
    expect(maskRecordChunk).toContain(line);
  }
});
