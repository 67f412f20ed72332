import { describe, expect, it } from 'vitest';
import { joinColour, sharedColour, splitColour, withIntensity, withScreenColour } from './screenColour';

const rounded = (channels: readonly number[] | null): number[] =>
  channels!.map((channel) => Number(channel.toFixed(2)));

describe('linear colours on a screen', () => {
  it('shows linear values as sRGB', () => {
    expect(splitColour([1, 0, 0.5])).toEqual({ hex: '#ff00bc', intensity: 1 });
    expect(joinColour('#ff00bc', 1)![2]).toBeCloseTo(0.5028865, 6);
  });

  it('splits brightness above 1 off, and puts it back', () => {
    const { hex, intensity } = splitColour([4, 2, 0]);
    expect(intensity).toBe(4);
    expect(rounded(joinColour(hex, intensity))).toEqual([4, 2.01, 0]);
  });

  it.each([
    ['#ff0000', [3, 0, 0]],
    ['#00ff00', [0, 3, 0]],
    ['#0000ff', [0, 0, 3]],
  ] as const)('%s has its brightness in the one channel that is above 1', (hex, [r, g, b]) => {
    expect(splitColour([r, g, b])).toEqual({ hex, intensity: 3 });
    expect(joinColour(hex, 3)).toEqual([r, g, b]);
    expect(withIntensity(6)([r, g, b])).toEqual([2 * r, 2 * g, 2 * b]);
  });

  it('cuts what is below 0', () => {
    expect(splitColour([-1, 0.5, 1]).hex).toBe('#00bcff');
  });

  it('comes back to every screen colour', () => {
    for (let i = 0; i < 256; i++) {
      const hex = `#${i.toString(16).padStart(2, '0').repeat(3)}`;
      expect(splitColour(joinColour(hex, 1)!).hex).toBe(hex);
    }
  });

  it.each(['', '#12', 'red', '#12345g'])("refuses '%s'", (text) => {
    expect(joinColour(text, 1)).toBeNull();
    expect(withScreenColour(text)).toBeNull();
  });

  it('takes the short form, without the sign', () => {
    expect(joinColour('f0a', 1)).toEqual(joinColour('#ff00aa', 1));
  });
});

describe('edits of a colour', () => {
  it('gives several another screen colour, each at its own intensity', () => {
    const update = withScreenColour('#ff0000')!;
    expect([update([0, 0.5, 1]), update([4, 2, 0])]).toEqual([
      [1, 0, 0],
      [4, 0, 0],
    ]);
  });

  it('gives several another intensity, each in its own hue, exactly', () => {
    const update = withIntensity(2);
    expect([update([1, 0.123456789, 0]), update([8, 4, 0.4])]).toEqual([
      [2, 0.246913578, 0],
      [2, 1, 0.1],
    ]);
  });

  it('shows the intensity that was given, of dark colours too', () => {
    const bright = withIntensity(3)([0.2, 0.1, 0]);
    expect(splitColour(bright)).toEqual({ hex: '#ffbc00', intensity: 3 });
    expect(withIntensity(1)(bright)[1]).toBeCloseTo(0.5);
    expect([withIntensity(1)([0.2, 0.1, 0]), withIntensity(5)([0, 0, 0])]).toEqual([
      [0.2, 0.1, 0],
      [0, 0, 0],
    ]);
  });

  it.each([0.9, Number.NaN, Infinity])('refuses the intensity %s', (intensity) => {
    expect(() => withIntensity(intensity)).toThrow(/at least 1/);
  });

  it('says what several share', () => {
    expect(sharedColour([[4, 2, 0]])).toEqual({ hex: '#ffbc00', intensity: 4 });
    expect(
      sharedColour([
        [4, 2, 0],
        [1, 0.5, 0],
      ]),
    ).toEqual({ hex: '#ffbc00', intensity: null });
    expect(
      sharedColour([
        [1, 0, 0],
        [0, 1, 0],
      ]),
    ).toEqual({ hex: null, intensity: 1 });
  });
});
