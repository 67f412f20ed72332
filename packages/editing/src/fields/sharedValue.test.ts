import { expect, it } from 'vitest';
import { sharedValue, withCoordinate } from './sharedValue';

it('gives the one value that all owners have', () => {
  expect(sharedValue([3])).toEqual({ value: 3, mixed: false });
  expect(sharedValue([null, null])).toEqual({ value: null, mixed: false });
  expect(
    sharedValue([
      [1, 2, 3],
      [1, 2, 3],
    ]),
  ).toEqual({ value: [1, 2, 3], mixed: false });
});

it('says of differing values what they share', () => {
  expect(sharedValue([3, 4])).toEqual({ value: null, mixed: true });
  expect(sharedValue([null, 'a'])).toEqual({ value: null, mixed: true });
  expect(sharedValue([null, [1, 2, 3]])).toEqual({ value: null, mixed: true });
  const triples = [
    [1, 2, 3],
    [1, 5, 3],
    [1, 2, 4],
  ] as const;
  expect(sharedValue(triples)).toEqual({ value: null, mixed: true, parts: [1, null, null] });
});

it('sets one coordinate, and leaves the others as they are', () => {
  expect(withCoordinate(1, 9)([0.1, 0.2, 0.3])).toEqual([0.1, 9, 0.3]);
  expect(withCoordinate(2, (z) => z * 2)([0.1, 0.2, 0.3])).toEqual([0.1, 0.2, 0.6]);
});
