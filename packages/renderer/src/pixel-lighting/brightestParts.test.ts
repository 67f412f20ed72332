import { Color } from 'three';
import { expect, test } from 'vitest';
import { brightestParts } from './brightestParts';

/** Runs `brightestParts` on lights of given brightness. @returns lights found, number of draws, and reported progress */
function find(
  lights: readonly number[],
  most: number,
): { single: number[][]; rest: readonly number[]; draws: number; told: number[] } {
  let draws = 0;
  const measure = (parts: readonly number[]): Color => {
    draws++;
    return new Color(
      parts.reduce((sum, i) => sum + lights[i], 0),
      0,
      0,
    );
  };
  const told: number[] = [];
  const search = brightestParts([...lights.keys()], measure, most);
  for (;;) {
    const step = search.next();
    if (step.done === true) {
      const { single, rest } = step.value;
      return { single: single.map(({ parts, color }) => [...parts, color.r]), rest, draws, told };
    }
    told.push(step.value);
  }
}

test('lights that give nothing are found dark in groups, by few draws', () => {
  const lights = Array.from({ length: 4096 }, (_, i) => ({ 7: 3, 900: 1, 901: 2, 4095: 5 })[i] ?? 0);
  const { single, rest, draws, told } = find(lights, 100);
  expect(single).toEqual([
    [4095, 5],
    [7, 3],
    [901, 2],
    [900, 1],
  ]);
  expect(rest).toEqual([]);
  expect(draws).toBeLessThan(90);
  expect(told).toEqual(told.toSorted((a, b) => a - b));
});

test('the brightest of many are told apart, and the others are the rest', () => {
  const lights = Array.from({ length: 64 }, (_, i) => (i % 16 === 3 ? 50 : 1));
  const { single, rest } = find(lights, 4);
  expect(single.map(([i]) => i).toSorted((a, b) => a - b)).toEqual([3, 19, 35, 51]);
  expect(rest).toHaveLength(60);
});

test('draws are bounded, whatever the lights', () => {
  const { single, rest, draws } = find(
    Array.from({ length: 10_000 }, () => 1),
    16,
  );
  expect(draws).toBeLessThan(8 * 16 + 64 + 4);
  expect(single.length + rest.length).toBe(10_000);
});

test('one light, none, and none that gives light', () => {
  expect(find([2], 8)).toMatchObject({ single: [[0, 2]], rest: [] });
  expect(find([], 8)).toMatchObject({ single: [], rest: [], draws: 0 });
  expect(find([0, 0, 0], 8)).toMatchObject({ single: [], rest: [], draws: 1 });
});
