import {
  checkFieldValue,
  colourKeys,
  type Curve,
  curveAt,
  fullKeys,
  type Gradient,
  gradient,
  gradientAt,
  joinKeys,
  opacityKeys,
  sameValue,
} from '@farol/editing/fields';
import { expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { frozenCopy } from './FieldOwner';
import { randomFieldValue } from './randomFieldValue';

test('a curve is straight between keys, constant beyond them, and steps where two keys are at one time', () => {
  const curve: Curve = [
    [0.2, 1],
    [0.4, 3],
    [0.4, -1],
    [0.8, 1],
  ];
  const values = [0, 0.2, 0.3, 0.4, 0.6, 0.8, 1].map((time) => curveAt(curve, time));
  [1, 1, 2, -1, 0, 1, 1].forEach((value, i) => expect(values[i]).toBeCloseTo(value, 12));
});

test('a gradient has its colours and its opacities at times of their own', () => {
  const sunset: Gradient = [
    [0, [1, 0, 0], null],
    [0.5, null, 1],
    [1, [0, 0, 2], 0],
  ];
  expect(gradientAt(sunset, 0)).toEqual({ colour: [1, 0, 0], opacity: 1 });
  expect(gradientAt(sunset, 0.75)).toEqual({ colour: [0.25, 0, 1.5], opacity: 0.5 });
  expect(fullKeys(sunset)).toEqual([
    [0, [1, 0, 0], 1],
    [0.5, [0.5, 0, 1], 1],
    [1, [0, 0, 2], 0],
  ]);
});

test('stops of colour and of opacity make keys that mean the same, and full keys mean the same again', () => {
  const random = createRandom(11);
  const field = gradient([[0, [1, 1, 1], 1]]);
  for (let n = 0; n < 200; n++) {
    const value = randomFieldValue(field, random) as Gradient;
    const joined = joinKeys(colourKeys(value), opacityKeys(value));
    expect(checkFieldValue(field, joined)).toBeNull();
    expect(colourKeys(joined)).toEqual(colourKeys(value));
    expect(opacityKeys(joined)).toEqual(opacityKeys(value));
    const full = fullKeys(value);
    for (let i = 0; i <= 40; i++) {
      const [a, b] = [gradientAt(value, i / 40), gradientAt(full, i / 40)];
      expect(b.opacity).toBeCloseTo(a.opacity, 9);
      b.colour.forEach((channel, c) => expect(channel).toBeCloseTo(a.colour[c], 9));
    }
  }
});

test('a value of keys is copied and frozen whole, and compared by what is in it', () => {
  const given: [number, number[], number][] = [[-0, [1, -0, 1], 0.5]];
  const kept = frozenCopy(given as unknown as Gradient) as Gradient;
  given[0][1][0] = 9;
  given[0][2] = 9;
  expect(kept).toEqual([[0, [1, 0, 1], 0.5]]);
  expect(Object.is(kept[0][1]![1], 0)).toBe(true);
  expect(Object.isFrozen(kept) && Object.isFrozen(kept[0]) && Object.isFrozen(kept[0][1])).toBe(true);
  expect(sameValue(kept, [[0, [1, 0, 1], 0.5]])).toBe(true);
  expect(sameValue(kept, [[0, [1, 0, 1], 0.6]])).toBe(false);
  expect(sameValue(kept, [[0, null, 0.5]])).toBe(false);
  expect(sameValue(kept, [...kept, [1, null, 0]])).toBe(false);
  expect(sameValue([[0, 1]], [[0, 2]])).toBe(false);
});
