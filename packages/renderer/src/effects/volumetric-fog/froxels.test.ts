import { describe, expect, it } from 'vitest';
import { sliceDepth } from './froxels';

/** Scattered light and transmittance of uniform fog, summed by slices as in fogIntegrate.glsl. */
function integrate(extinction: number, source: number, depth: number, slices: number): [number, number] {
  let light = 0;
  let through = 1;
  for (let i = 0; i < slices; i++) {
    const passes = Math.exp(-extinction * (sliceDepth(i + 1, slices, depth) - sliceDepth(i, slices, depth)));
    light += (through * source * (1 - passes)) / extinction;
    through *= passes;
  }
  return [light, through];
}

describe('the slices of depth', () => {
  it('begin at the eye, end at the distance, and each is thicker than the one before', () => {
    expect(sliceDepth(0, 64, 100)).toBe(0);
    expect(sliceDepth(64, 64, 100)).toBeCloseTo(100, 9);
    for (let i = 1; i < 64; i++) {
      const thickness = sliceDepth(i + 1, 64, 100) - sliceDepth(i, 64, 100);
      const before = sliceDepth(i, 64, 100) - sliceDepth(i - 1, 64, 100);
      expect(thickness / before).toBeCloseTo(Math.exp(4 / 64), 9);
    }
  });

  it.each([
    [0.01, 32],
    [0.05, 64],
    [0.5, 64],
  ])(
    'of fog with an extinction of %d 1/m pass as much as Beer and Lambert have it (%i slices)',
    (extinction, slices) => {
      const depth = 60;
      const [light, through] = integrate(extinction, 0.3, depth, slices);
      expect(through).toBeCloseTo(Math.exp(-extinction * depth), 12);
      expect(light).toBeCloseTo((0.3 / extinction) * (1 - Math.exp(-extinction * depth)), 9);
    },
  );
});
