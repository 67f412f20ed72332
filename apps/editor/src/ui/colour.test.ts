import { describe, expect, it } from 'vitest';
import { joinColour, splitColour } from './colour';

describe('colours', () => {
  it('shows linear values as sRGB', () => {
    expect(splitColour([1, 0, 0.5])).toEqual({ hex: '#ff00bc', intensity: 1 });
    expect(joinColour('#ff00bc', 1)![2]).toBeCloseTo(0.5028865, 6);
  });

  it('splits brightness above 1 off, and puts it back', () => {
    const { hex, intensity } = splitColour([4, 2, 0]);
    expect(intensity).toBe(4);
    expect(joinColour(hex, intensity)!.map((channel) => Math.round(channel * 100) / 100)).toEqual([4, 2.01, 0]);
  });

  it('comes back to every screen colour', () => {
    for (let i = 0; i < 256; i++) {
      const hex = `#${i.toString(16).padStart(2, '0').repeat(3)}`;
      expect(splitColour(joinColour(hex, 1)!).hex).toBe(hex);
    }
  });

  it.each(['', '#12', 'red', '#12345g'])("refuses '%s'", (text) => {
    expect(joinColour(text, 1)).toBeNull();
  });

  it('takes the short form, without the sign', () => {
    expect(joinColour('f0a', 1)).toEqual(joinColour('#ff00aa', 1));
  });
});
