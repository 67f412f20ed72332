import { describe, expect, it } from 'vitest';
import type { Curve, Gradient } from './Field';
import { colourKeys, curveAt, fullKeys, gradientAt, joinKeys, opacityKeys } from './keys';

/** Colours whose three channels change by different amounts, and opacities at other times. */
const gradient: Gradient = [
  [0.2, [0, 2, 1], 0.5],
  [0.4, null, 1],
  [0.6, [4, 1, 3], null],
  [1, null, 0],
];

describe('the value of keys at a time', () => {
  it('goes straight from key to key, and stays before the first and after the last', () => {
    const curve: Curve = [
      [0.2, 1],
      [0.4, 5],
      [0.8, 3],
    ];
    const values = [0, 0.2, 0.25, 0.4, 0.6, 0.8, 1].map((time) => curveAt(curve, time));
    for (const [i, value] of [1, 1, 2, 5, 4, 3, 3].entries()) expect(values[i]).toBeCloseTo(value, 12);
  });

  it('jumps where two keys are at one time', () => {
    const curve: Curve = [
      [0, 0],
      [0.5, 1],
      [0.5, 7],
    ];
    expect([curveAt(curve, 0.25), curveAt(curve, 0.5), curveAt(curve, 0.75)]).toEqual([0.5, 7, 7]);
  });

  it.each([
    [0, [0, 2, 1], 0.5],
    [0.3, [1, 1.75, 1.5], 0.75],
    [0.5, [3, 1.25, 2.5], 1 - 1 / 6],
    [0.8, [4, 1, 3], 1 / 3],
    [1, [4, 1, 3], 0],
  ] as const)(
    'of a gradient at %d is each channel of the colour, and the opacity, by keys of their own',
    (time, colour, opacity) => {
      const at = gradientAt(gradient, time);
      for (const [i, channel] of colour.entries()) expect(at.colour[i], `channel ${i}`).toBeCloseTo(channel, 12);
      expect(at.opacity).toBeCloseTo(opacity, 12);
    },
  );
});

it('stops of colour and of opacity, taken apart, make the gradient again', () => {
  expect(joinKeys(colourKeys(gradient), opacityKeys(gradient))).toEqual(gradient);
});

it('full keys have in each key the colour and opacity that the gradient has there', () => {
  for (const [i, [time, colour, opacity]] of fullKeys(gradient).entries()) {
    expect(time).toBe(gradient[i][0]);
    expect({ colour, opacity }).toEqual(gradientAt(gradient, time));
  }
});
