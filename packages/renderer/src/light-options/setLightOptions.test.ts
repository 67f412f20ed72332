import { CubeTexture, DirectionalLight, type Light, PointLight, RectAreaLight, SpotLight, Texture } from 'three';
import { expect, it } from 'vitest';
import { cookieOf, profileOf } from '../lighting/lightCookie';
import type { LightOptions } from './LightOptions';
import type { LightOptionName } from './lightRules';
import { setLightOptions } from './setLightOptions';

/** For each option: a light that has it, one that does not, values that are allowed, and some that are not. */
const cases: Record<LightOptionName, { on: () => Light; not: () => Light; good: unknown[]; bad: unknown[] }> = {
  ambient: {
    on: () => new SpotLight(),
    not: () => new RectAreaLight(),
    good: [[0, 1, 2]],
    bad: [[0, 1], [0, -1, 0], 1],
  },
  specular: { on: () => new DirectionalLight(), not: () => new RectAreaLight(), good: [[0, 0, 0]], bad: ['red', null] },
  spotExponent: { on: () => new SpotLight(), not: () => new PointLight(), good: [0, 8], bad: [-1, NaN, '8'] },
  attenuation: {
    on: () => new PointLight(),
    not: () => new DirectionalLight(),
    good: [
      { kind: 'near-far', near: 1, far: 4 },
      { kind: 'polynomial', constant: 1, linear: 0, quadratic: 0, range: 0 },
    ],
    bad: [
      { kind: 'near-far', near: 4, far: 1 },
      { kind: 'polynomial', constant: 0, linear: 0, quadratic: 0, range: 0 },
      { kind: 'linear', near: 1, far: 4 },
      null,
    ],
  },
  shape: {
    on: () => new RectAreaLight(),
    not: () => new SpotLight(),
    good: ['rectangle', 'disc', 'tube'],
    bad: ['disk'],
  },
  range: { on: () => new RectAreaLight(), not: () => new PointLight(), good: [0, 5], bad: [-1, Infinity, null] },
  shadowMapSize: { on: () => new RectAreaLight(), not: () => new PointLight(), good: [16, 8192], bad: [8, 8193] },
  shadowNormalBias: { on: () => new RectAreaLight(), not: () => new SpotLight(), good: [0, 0.1], bad: [-0.1] },
  radius: { on: () => new PointLight(), not: () => new DirectionalLight(), good: [0, 0.2], bad: [-1] },
  angle: { on: () => new DirectionalLight(), not: () => new PointLight(), good: [0, 0.01], bad: [-1, 4] },
  cookie: {
    on: () => new PointLight(),
    not: () => new SpotLight(),
    good: [new CubeTexture(), null],
    bad: [new Texture(), 1],
  },
  profile: {
    on: () => new SpotLight(),
    not: () => new DirectionalLight(),
    good: [new Texture(), null],
    bad: ['lamp.ies'],
  },
};

it.each(Object.entries(cases))(
  '%s: takes what the light can have, refuses the rest, and changes nothing then',
  (name, one) => {
    for (const value of one.good) {
      const light = one.on();
      setLightOptions(light, { [name]: value });
      if (name === 'cookie') expect(cookieOf(light)).toBe(value);
      else if (name === 'profile') expect(profileOf(light)).toBe(value);
      else expect(light.userData.farol).toEqual({ [name]: value });
    }
    for (const value of one.bad) {
      const light = one.on();
      expect(() => setLightOptions(light, { [name]: value }), String(value)).toThrow(
        new RegExp(`^Farol: ${name} is .*; give `),
      );
      expect(light.userData).toEqual({});
    }
    const other = one.not();
    expect(() => setLightOptions(other, { [name]: one.good[0] })).toThrow(`Farol: a ${other.type} has no ${name}; a `);
  },
);

it('leaves what is not named, takes what is undefined back, and keeps textures from JSON', () => {
  const light = new RectAreaLight();
  setLightOptions(light, { range: 3 });
  setLightOptions(light, { shape: 'disc' });
  expect(light.userData).toEqual({ farol: { range: 3, shape: 'disc' } });
  expect(() => setLightOptions(light, { range: 4, shape: 'disk' as 'disc' })).toThrow(
    'Farol: shape is "disk"; give rectangle, disc, tube.',
  );
  expect(light.userData.farol).toEqual({ range: 3, shape: 'disc' });
  setLightOptions(light, { range: undefined, shape: undefined });
  expect(light.userData.farol).toEqual({});
  const lamp = new PointLight();
  setLightOptions(lamp, { profile: new Texture() });
  expect(JSON.stringify(lamp.userData)).toBe('{}');
  setLightOptions(lamp, { profile: undefined });
  expect(profileOf(lamp)).toBeNull();
});

it('names an option that there is not, and the nearest', () => {
  const options = { ranges: 3 } as LightOptions;
  expect(() => setLightOptions(new RectAreaLight(), options)).toThrow(
    /^Farol: unknown light option "ranges"; use one of: ambient, .* Is "range" meant\?$/,
  );
});
