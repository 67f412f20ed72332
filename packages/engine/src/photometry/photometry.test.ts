import { describe, expect, test } from 'vitest';
import { chromaticityOf, colourOfKelvin, lightOfKelvin, luminanceOf } from './colourTemperature';
import { evOfCamera, evOfIlluminance, evOfLuminance, exposureOfEV } from './exposure';
import { lampEfficacies } from './lampKinds';
import { lightPresets, valuesOfPreset } from './lightPresets';
import { type IntensityUnit, type PhotometricLight, solidAngleOf, unitFactor, unitsFor } from './lightUnits';
import { formatIntensity, shownUnit } from './shownIntensity';

const light = (values: Partial<PhotometricLight>): PhotometricLight => ({
  ...{ type: 'point', cutoff: Math.PI / 6, penumbra: 0, exponent: 0, width: 1, height: 1, lamp: 'incandescent' },
  ...values,
});

/** Wyszecki & Stiles 1982, Color Science, table 1(3.11): u, v of Planck's locus (CIE 1960) by mireds. */
const planck: readonly (readonly [number, number, number])[] = [
  [275, 0.23247, 0.33904],
  [300, 0.2401, 0.34308],
  [325, 0.24792, 0.34655],
  [350, 0.25591, 0.34951],
  [375, 0.264, 0.352],
  [400, 0.27218, 0.35407],
  [425, 0.28039, 0.35577],
  [450, 0.28863, 0.35714],
  [475, 0.29685, 0.35823],
  [500, 0.30505, 0.35907],
  [525, 0.3132, 0.35968],
  [550, 0.32129, 0.36011],
  [575, 0.32931, 0.36038],
  [600, 0.33724, 0.36051],
];

/** Linear sRGB with the largest channel at 1, from x and y: IEC 61966-2-1. */
function linearOf(x: number, y: number): number[] {
  const [X, Z] = [x / y, (1 - x - y) / y];
  const rgb = [
    3.2404542 * X - 1.5371385 - 0.4985314 * Z,
    -0.969266 * X + 1.8760108 + 0.041556 * Z,
    0.0556434 * X - 0.2040259 + 1.0572252 * Z,
  ].map((channel) => Math.max(0, channel));
  return rgb.map((channel) => channel / Math.max(...rgb));
}

const furthest = (a: readonly number[], b: readonly number[]): number =>
  Math.max(...a.map((value, i) => Math.abs(value - b[i])));

describe('colour temperature', () => {
  test.each(planck)('Planck’s locus at %d mired is that of the table', (mired, u, v) => {
    const scale = 2 * u - 8 * v + 4;
    expect(furthest(colourOfKelvin(1e6 / mired), linearOf((3 * u) / scale, (2 * v) / scale))).toBeLessThan(0.005);
  });

  // CIE 15:2004, table T.3 and appendix: chromaticities of the standard illuminants
  test.each([
    ['A', 2855.5, 0.44758, 0.40745],
    ['D50', 5003, 0.34567, 0.35851],
    ['D55', 5503, 0.33243, 0.34744],
    ['D65', 6504, 0.31272, 0.32903],
    ['D75', 7504, 0.29903, 0.31488],
    // colour-science, CCT_to_xy_CIE_D, https://colour.readthedocs.io/en/latest/
    ['D65', 6504.38938305, 0.3127077, 0.3291128],
  ])('illuminant %s', (_, kelvin, x, y) => {
    expect(furthest(chromaticityOf(kelvin), [x, y])).toBeLessThan(0.0005);
    expect(furthest(colourOfKelvin(kelvin), linearOf(x, y))).toBeLessThan(0.005);
  });

  // integrals of Planck's law with the CIE 1931 observer at 1 nm, c2 = 1.4388e-2 m K
  test.each([
    [1000, [1, 0.0086, 0]],
    [1500, [1, 0.133, 0]],
    [1850, [1, 0.2203, 0]],
    [2700, [1, 0.4153, 0.0991]],
    [3500, [1, 0.5705, 0.2593]],
  ])('%d K as integrated from spectra', (kelvin, rgb) => {
    expect(furthest(colourOfKelvin(kelvin), rgb)).toBeLessThan(0.005);
  });

  test('D65 is white, and light of any temperature has a luminance of 1', () => {
    expect(furthest(colourOfKelvin(6504), [1, 1, 1])).toBeLessThan(0.005);
    for (const kelvin of [500, 1000, 1900, 3999, 4000, 6500, 25000, 1e6])
      expect(luminanceOf(lightOfKelvin(kelvin))).toBeCloseTo(1, 9);
  });
});

describe('solid angles and units', () => {
  test('a point light’s is 4π', () => {
    expect(solidAngleOf(light({}))).toBeCloseTo(12.566, 3);
  });

  test.each([
    [0, 0],
    [0.3, 0],
    [1, 0],
    [0, 8],
  ])('a spot’s is the integral of its light over the sphere: penumbra %d, exponent %d', (penumbra, exponent) => {
    const spot = light({ type: 'spot', cutoff: 0.7, penumbra, exponent });
    const edge = Math.cos(0.7);
    const full = Math.cos(0.7 * (1 - penumbra));
    const part = (cosine: number): number => {
      if (exponent > 0) return cosine > edge ? cosine ** exponent : 0;
      const share = full > edge ? Math.min(1, Math.max(0, (cosine - edge) / (full - edge))) : Number(cosine > edge);
      return share * share * (3 - 2 * share);
    };
    const steps = 200000;
    let sum = 0;
    for (let i = 0; i < steps; i++) sum += part((i + 0.5) / steps);
    expect(solidAngleOf(spot)).toBeCloseTo((2 * Math.PI * sum) / steps, 4);
  });

  // IES Lighting Handbook, 10th edition, chapter 5: Φ = 4π I, Φ = 2π (1 - cos α) I, M = π L, E = I / d²
  test.each<[string, Partial<PhotometricLight>, IntensityUnit, number]>([
    ['1 cd all round is 12.57 lm', {}, 'lumen', 12.566],
    ['a cone of 60° is 0.842 sr', { type: 'spot' }, 'lumen', 0.8418],
    ['a hemisphere is 6.283 sr', { type: 'spot', cutoff: Math.PI / 2 }, 'lumen', 6.2832],
    ['a panel of 0.36 m² at 1 nt is 1.131 lm', { type: 'rectangle', width: 0.6, height: 0.6 }, 'lumen', 1.131],
    ['a disc of 1 m at 1 nt is 2.467 lm', { type: 'disc' }, 'lumen', 2.4674],
    ['a T8 tube at 1 nt is 0.3079 lm', { type: 'tube', width: 1.2, height: 0.026 }, 'lumen', 0.30791],
    ['a panel seen from its front', { type: 'rectangle', width: 2, height: 0.5 }, 'candela', 1],
    ['lux at 1 m are candela', {}, 'lux', 1],
    ['lux of the sun are three’s', { type: 'directional' }, 'lux', 1],
  ])('%s', (_, values, unit, factor) => {
    expect(Math.abs(unitFactor(light(values), unit) / factor - 1)).toBeLessThan(0.001);
  });

  // sources: lampKinds.ts
  test.each([
    ['incandescent', 60, 800],
    ['halogen', 500, 9900],
    ['fluorescent', 32, 2800],
    ['led', 8, 800],
  ] as const)('%s lamp of %d W gives %d lm', (lamp, watts, lumens) => {
    expect(Math.abs((lampEfficacies[lamp] * watts) / lumens - 1)).toBeLessThan(0.01);
    const lamped = light({ lamp });
    expect(unitFactor(lamped, 'lumen') / unitFactor(lamped, 'watt')).toBeCloseTo(lampEfficacies[lamp]);
  });

  test('units that a type does not have are not shown', () => {
    const measured = { ...light({ type: 'directional' }), intensity: 3, intensityUnit: 'lumen' as const };
    expect([shownUnit(measured), formatIntensity(measured)]).toEqual(['lux', '3 lx']);
  });
});

test('a light with a profile has the lumens of its file, and its units once the file is there', () => {
  const shaped = light({ profile: 'down', profileSolidAngle: Math.PI });
  expect(unitFactor(shaped, 'lumen')).toBe(Math.PI);
  expect(unitsFor(light({ profile: 'down', profileSolidAngle: null }))).toEqual(['candela']);
  expect(unitsFor({ ...shaped, profileIntensity: true })).toEqual(['candela']);
  expect(unitsFor({ ...shaped, type: 'spot' })).toEqual(['candela']);
});

describe('presets', () => {
  test.each(Object.keys(lightPresets))('%s has the amount that it says', (name) => {
    const preset = lightPresets[name];
    const before = light({ type: 'ambient', cutoff: 1, width: 3, profile: 'down' });
    const made = { ...before, ...valuesOfPreset(preset, before) } as unknown as Parameters<typeof formatIntensity>[0];
    expect(made.intensity * unitFactor(made, preset.unit)).toBeCloseTo(preset.amount, 6);
    expect(unitsFor(made)).toContain(preset.unit);
    expect(shownUnit(made)).toBe(preset.unit);
  });

  // sources: lightPresets.ts
  test.each([
    ['candle', 'candela', 1, 1850],
    ['bulb40', 'lumen', 450, 2700],
    ['bulb60', 'lumen', 800, 2700],
    ['bulb100', 'lumen', 1600, 2700],
    ['led', 'lumen', 800, 3000],
    ['tube', 'lumen', 2800, 4100],
    ['sodium', 'lumen', 9500, 2100],
    ['floodlight', 'lumen', 36000, 4000],
    ['headlamp', 'lumen', 1000, 3200],
    ['sun', 'lux', 100000, 5500],
    ['overcast', 'lux', 5000, 6500],
    ['fullMoon', 'lux', 0.25, 4100],
  ] as const)('%s has the %s of its source, %d, and %d K', (name, unit, amount, kelvin) => {
    const values = valuesOfPreset(lightPresets[name], light({}));
    const made = { ...light({}), ...values } as PhotometricLight;
    const found = Number(values.intensity) * unitFactor(made, unit);
    expect(Math.abs(found / amount - 1)).toBeLessThan(0.01);
    expect(made).toMatchObject({ kelvin });
  });

  test('a bulb of 60 W is 64 cd', () => {
    expect(valuesOfPreset(lightPresets.bulb60, light({})).intensity).toBeCloseTo(63.66, 1);
  });
});

describe('exposure', () => {
  // ISO 2720: exposure values for full stops of f-number and time
  test.each([
    [1, 1, 100, 0],
    [1.4, 1, 100, 1],
    [16, 1 / 125, 100, 15],
    [2.8, 1 / 60, 800, 6],
    [5.6, 1 / 30, 400, 8],
  ])('f/%d, %d s, ISO %d is EV %d', (aperture, time, iso, ev) => {
    expect(Math.abs(evOfCamera(aperture, time, iso) - ev)).toBeLessThan(0.15);
  });

  test('meters: 4,096 cd/m² and 81,920 lx are EV 15', () => {
    expect([evOfLuminance(4096), evOfIlluminance(81920)]).toEqual([15, 15]);
  });

  test('an evenly lit picture at its own exposure is as bright as the saturation based speed says, 10.4%', () => {
    for (const luminance of [0.01, 1, 4096])
      expect(luminance * exposureOfEV(evOfLuminance(luminance))).toBeCloseTo(12.5 / (100 * 1.2), 6);
  });
});
