import type { CurveField } from '@farol/engine/fields';
import { expect, test } from 'vitest';
import { curvePresets } from './curvePresets';
import { gradientCss } from './gradientCss';
import { insertKey, moveKey, type TimedKey } from './keyList';
import { curvePoints, shareOf, valueAtShare, valueRange } from './valueRange';

type Key = readonly [number, string];
const keys: readonly Key[] = [
  [0, 'a'],
  [0.5, 'b'],
  [0.5, 'c'],
  [1, 'd'],
];
const names = (list: readonly TimedKey[]): string => list.map(([, name]) => String(name)).join('');

test('a new key comes after those at its time', () => {
  expect(insertKey<Key>(keys, [0.5, 'n'])).toMatchObject({ index: 3 });
  expect(names(insertKey<Key>(keys, [0.5, 'n']).keys)).toBe('abcnd');
  expect(insertKey<Key>(keys, [0, 'n']).index).toBe(1);
  expect(insertKey<Key>(keys, [1, 'n']).index).toBe(4);
});

test('a key that is moved passes others, and stays on its side of one at its time', () => {
  expect(names(moveKey<Key>(keys, 1, [0.5, 'B']).keys)).toBe('aBcd');
  expect(names(moveKey<Key>(keys, 2, [0.5, 'C']).keys)).toBe('abCd');
  expect(names(moveKey<Key>(keys, 1, [0.6, 'B']).keys)).toBe('acBd');
  expect(moveKey<Key>(keys, 0, [0.5, 'A'])).toMatchObject({ index: 0 });
  expect(names(moveKey<Key>(keys, 0, [0.7, 'A']).keys)).toBe('bcAd');
  expect(moveKey<Key>(keys, 3, [0.5, 'D']).index).toBe(3);
  expect(moveKey<Key>(keys, 3, [0.2, 'D']).index).toBe(1);
  expect(names(moveKey<Key>(keys, 3, [0, 'D']).keys)).toBe('aDbc');
});

test('keys stay in order wherever one is dragged, and none is lost', () => {
  for (let from = 0; from < keys.length; from++) {
    for (let to = 0; to <= 20; to++) {
      const { keys: moved, index } = moveKey<Key>(keys, from, [to / 20, 'x']);
      expect(moved[index]).toEqual([to / 20, 'x']);
      expect(moved).toHaveLength(4);
      for (let i = 1; i < 4; i++) expect(moved[i][0]).toBeGreaterThanOrEqual(moved[i - 1][0]);
    }
  }
});

const field = (min?: number, max?: number): CurveField => ({ kind: 'curve', default: [[0, 1]], help: '', min, max });

test('the graph has room for all keys, within the limits of the field', () => {
  expect(valueRange(field(0, 1), [[0, 1]])).toEqual({ low: 0, high: 1 });
  expect(valueRange(field(0), [[0, 1]])).toEqual({ low: 0, high: 1.2 });
  expect(valueRange(field(0), [[0, 0]])).toEqual({ low: 0, high: 1 });
  const { low, high } = valueRange(field(), [
    [0, -3],
    [1, 40],
  ]);
  expect(low).toBeLessThan(-3);
  expect(high).toBeGreaterThan(40);
  expect(valueRange(field(-1, 1), [[0, -1]]).low).toBe(-1);
});

test('a place of the graph is a value with few digits, and back', () => {
  const range = { low: 0, high: 1.2 };
  for (let i = 0; i <= 100; i++) {
    const value = valueAtShare(range, i / 100);
    expect(Math.abs(shareOf(range, value) - i / 100)).toBeLessThan(0.01);
    expect(String(value).length).toBeLessThanOrEqual(5);
  }
  expect(valueAtShare(range, 2)).toBe(1.2);
  expect(valueAtShare(range, -1)).toBe(0);
  expect(curvePoints([[0.5, 0.6]], range)).toBe('0,0.5 0.5,0.5 1,0.5');
});

test('presets lie between the values that they are asked for', () => {
  for (const { curve } of curvePresets(0.5, 3)) {
    for (const [time, value] of curve) {
      expect(time >= 0 && time <= 1 && value >= 0.5 && value <= 3).toBe(true);
    }
    expect(Math.max(...curve.map(([, value]) => value))).toBe(3);
  }
});

test('a gradient is shown with its colours, brighter ones as a screen can, and its opacity', () => {
  const css = gradientCss([
    [0, [4, 0, 0], 1],
    [1, [0, 0, 1], 0],
  ]);
  expect(css).toMatch(/^linear-gradient\(90deg, #ff0000ff 0%, /);
  expect(css).toMatch(/#0000ff00 100%\)$/);
  expect(gradientCss([[0.5, [1, 1, 1], 0]], true)).toContain('#ffffffff 50%');
});
