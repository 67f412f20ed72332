import { gen, sample } from 'fast-check';
import { expect, test } from 'vitest';
import { FuzzRandom } from './FuzzRandom';
import { mutate, textOf } from './hostileValues';

/** Lists and objects in one another. */
const nested = (depth: number): unknown => {
  let value: unknown = [-0, 1.5, 'a"\n', null, true, {}, []];
  for (let i = 0; i < depth; i++) value = i % 2 === 0 ? [value, i] : { a: value, 'b\n': i };
  return value;
};

test('values deeper than the stack are written and changed as others are', () => {
  expect(textOf(nested(50))).toBe(JSON.stringify(nested(50)));
  const depth = 200_000;
  const deep = nested(depth);
  expect(() => JSON.stringify(deep)).toThrow(RangeError);
  const text = textOf(deep);
  expect(text.length).toBeGreaterThan(depth * 8);
  expect(textOf(JSON.parse(text))).toBe(text);
  // what is shallow is at the start and the end of the deep one's text
  expect(text.slice(text.indexOf('[0,1.5'))).toMatch(/^\[0,1\.5,"a\\"\\n",null,true,\{\},\[\]\],0\]/);
  for (const draw of sample(gen(), { seed: 1, numRuns: 5 })) mutate(deep, new FuzzRandom(draw));
  expect(textOf(deep)).not.toBe(text);
});
