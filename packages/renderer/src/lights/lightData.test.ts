import { PointLight, SpotLight } from 'three';
import { describe, expect, it } from 'vitest';
import { type FarolAttenuation, lightRange } from './lightData';

describe('the range of a light', () => {
  it.each([Infinity, 1e38, 1e20, 0, -5, NaN])('has no limit where its distance is %d', (distance) => {
    expect(lightRange(new PointLight(0xffffff, 1, distance))).toBe(0);
    expect(lightRange(new SpotLight(0xffffff, 1, distance) as unknown as PointLight)).toBe(0);
  });

  it.each([1e-20, 0.5, 1e12])('is its distance of %d', (distance) => {
    expect(lightRange(new PointLight(0xffffff, 1, distance))).toBe(distance);
  });

  it('is that of an attenuation of its own', () => {
    const light = new PointLight(0xffffff, 1, 3);
    const ranges = (attenuation: FarolAttenuation) => {
      light.userData.farol = { attenuation };
      return lightRange(light);
    };
    const factors = { kind: 'polynomial', constant: 1, linear: 0, quadratic: 0 } as const;
    expect(ranges({ ...factors, range: 7 })).toBe(7);
    expect(ranges({ ...factors, range: 0 })).toBe(0);
    expect(ranges({ ...factors, range: Infinity })).toBe(0);
    expect(ranges({ kind: 'near-far', near: 1, far: 4 })).toBe(4);
    expect(ranges({ kind: 'near-far', near: 1, far: Infinity })).toBe(0);
  });
});
