import { expect, it } from 'vitest';
import { rangeOf } from './Tree';

const items = [...'abcde'];

it.each([
  ['b', 'd', 'bcd'],
  ['d', 'b', 'dcb'],
  ['c', 'c', 'c'],
  ['a', 'e', 'abcde'],
  ['e', 'a', 'edcba'],
])('from %s to %s is %s: the row that was clicked comes last', (from, to, range) => {
  expect(rangeOf(items, from, to)?.join('')).toBe(range);
});

it('is none where the first row is there no more, or was none', () => {
  expect([rangeOf(items, 'x', 'a'), rangeOf(items, null, 'a'), rangeOf(items, 'a', 'x')]).toEqual([null, null, null]);
});
