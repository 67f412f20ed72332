import { describe, expect, it } from 'vitest';
import { needsFineDepth } from './fineDepth';

describe('needsFineDepth', () => {
  it.each([
    ['a point light of 5 m', [0.05, 5, 1, 512, -0.002, true], false],
    ['the same with no bias', [0.05, 5, 1, 512, 0, true], true],
    ['the same with next to none', [0.05, 5, 1, 512, 0.0002, true], true],
    ['a point light that reaches 500 m', [0.5, 500, 1, 512, -0.002, true], true],
    ['a large map of it', [0.05, 5, 1, 2048, -0.002, true], true],
    ['the sun over 20 m', [1, 40, 0.1, 1024, -0.001, false], false],
    ['the sun over 10 m from 500', [0.5, 500, 0.2, 2048, -0.001, false], true],
    ['a near plane at nothing', [0, 5, 1, 512, -0.002, true], true],
  ] as const)('%s', (_, [near, far, scale, texels, bias, isPerspective], expected) => {
    expect(needsFineDepth(near, far, scale, texels, bias, isPerspective)).toBe(expected);
  });

  it('is where a step at half the range is wider than half a texel', () => {
    const [near, far, texels] = [0.1, 10, 512];
    const stepAt = (z: number) => {
      const depth = (at: number) => (far * (at - near)) / (at * (far - near));
      return 1 / 65536 / ((depth(z + 1e-4) - depth(z - 1e-4)) / 2e-4);
    };
    const limit = (scale: number) => needsFineDepth(near, far, scale, texels, -0.01, true);
    const texel = (scale: number) => (2 * (far / 2)) / (scale * texels);
    for (const scale of [0.5, 1, 1.2, 1.4, 2, 4]) expect(limit(scale)).toBe(stepAt(far / 2) > 0.5 * texel(scale));
  });
});
