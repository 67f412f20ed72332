import { describe, expect, it } from 'vitest';
import { phase, sliceDepth, slicesBefore } from './froxels';

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

  it('are found by depth again, and end at the last', () => {
    for (let i = 0; i <= 32; i += 0.25) expect(slicesBefore(sliceDepth(i, 32, 40), 32, 40)).toBeCloseTo(i, 9);
    expect(slicesBefore(-1, 32, 40)).toBe(0);
    expect(slicesBefore(41, 32, 40)).toBe(32);
    expect(slicesBefore(Infinity, 32, 40)).toBe(32);
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

describe('the phase function', () => {
  it.each([-0.8, -0.3, 0, 0.2, 0.6, 0.9])('of anisotropy %d is 1 over all directions, with that mean cosine', (g) => {
    const steps = 200_000;
    let sum = 0;
    let mean = 0;
    for (let i = 0; i < steps; i++) {
      const cosine = ((i + 0.5) / steps) * 2 - 1;
      const share = (phase(cosine, g) * 4 * Math.PI) / steps;
      sum += share;
      mean += share * cosine;
    }
    expect(sum).toBeCloseTo(1, 6);
    expect(mean).toBeCloseTo(g, 6);
  });
});
