import { expect, test } from 'vitest';
import { bakeCurves, CURVE_TEXELS, curveAt, curveIntegral, gradientAt } from './bakeCurves';
import type { CurveKey, GradientKey } from './ParticleSettings';

const curve: readonly CurveKey[] = [
  [0.25, 2],
  [0.5, 4],
  [0.5, 1],
  [0.75, 0],
];

test('a curve is straight between its keys, constant outside of them, and jumps where two have one time', () => {
  expect([0, 0.25, 0.375, 0.4999999, 0.5, 0.625, 0.75, 1].map((time) => curveAt(curve, time))).toEqual([
    2,
    2,
    3,
    expect.closeTo(4, 5),
    1,
    0.5,
    0,
    0,
  ]);
  expect(curveAt([[0.5, 7]], 0.1)).toBe(7);
});

test('the integral of a curve is that of its sum over small steps', () => {
  for (const time of [0, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 1]) {
    let sum = 0;
    for (let i = 0; i < 10_000; i++) sum += (curveAt(curve, ((i + 0.5) / 10_000) * time) * time) / 10_000;
    expect(curveIntegral(curve, time)).toBeCloseTo(sum, 3);
  }
});

test('baked rows hold colour and opacity, size and spin, from the beginning of a life to its end', () => {
  const colorOverLife: readonly GradientKey[] = [
    [0, [4, 0, 0], 1],
    [1, [0, 2, 0], 0],
  ];
  const data = bakeCurves({ colorOverLife, sizeOverLife: curve, spinOverLife: [[0, 3]] });
  const texel = (row: number, i: number) => [
    ...data.subarray(4 * (row * CURVE_TEXELS + i), 4 * (row * CURVE_TEXELS + i) + 4),
  ];
  const last = CURVE_TEXELS - 1;
  expect(texel(0, 0)).toEqual([4, 0, 0, 1]);
  expect(texel(0, last)).toEqual([0, 2, 0, 0]);
  expect(texel(0, 51)).toEqual([3.2, 0.4, 0, 0.8].map((value) => expect.closeTo(value, 5)));
  expect([texel(1, 0)[0], texel(1, last)[0]]).toEqual([2, 0]);
  expect([texel(1, 0)[1], texel(1, last)[1]]).toEqual([0, 3]);
});

test('a gradient with one key is that colour throughout', () => {
  const out = new Float32Array(4);
  gradientAt([[0.5, [1, 2, 3], 0.25]], 0.9, out);
  expect([...out]).toEqual([1, 2, 3, 0.25]);
});
