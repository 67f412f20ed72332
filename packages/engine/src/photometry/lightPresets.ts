import type { LampKind } from './lampKinds';
import { type IntensityUnit, type PhotometricLight, unitFactor } from './lightUnits';

/** Field values of a Light that a preset sets; angles in radians, lengths in metres. */
export interface LightPreset {
  readonly label: string;
  /** Kind of light: a Light's `type`. */
  readonly type: 'point' | 'spot' | 'rectangle' | 'disc' | 'tube' | 'directional' | 'hemisphere';
  readonly amount: number;
  readonly unit: IntensityUnit;
  readonly lamp?: LampKind;
  readonly kelvin: number;
  /** Size and range of the light; range 0 is unlimited. */
  readonly shape?: Readonly<Record<string, number>>;
}

const DEGREE = Math.PI / 180;

/**
 * Measured lamps and skies.
 *
 * - Candle: the old unit of luminous intensity; 1,850 K, and 4,100 K of moonlight:
 *   https://en.wikipedia.org/wiki/Color_temperature, table of light sources.
 * - Bulbs and the LED lamp: lumens as in `lampEfficacies`.
 * - Sodium, 100 W: 9,500 lm, General Electric's lamp catalogue of 1999, page 3-15,
 *   http://resodance.com/ali/lamplums.html; 2,100 K, and the metal halide lamp of 400 W, 36,000 lm and 4,000 K:
 *   https://www.hydroponics.net/learn/high_intensity_discharge_bulb_sp.php
 * - Headlamp: passing beam of an H4 lamp, UN Regulation 37, sheet H4.
 * - Sun, overcast sky and full moon: CIBSE, Code for interior lighting, examples of illuminance,
 *   https://help.iesve.com/ve2021/2_6__examples_of_illuminance.htm
 * - LED panel: an ordinary product; no standard names one.
 */
export const lightPresets: Readonly<Record<string, LightPreset>> = {
  candle: { label: 'Candle', type: 'point', amount: 1, unit: 'candela', kelvin: 1850, shape: { range: 8 } },
  bulb40: { label: '40 W bulb', type: 'point', amount: 450, unit: 'lumen', lamp: 'incandescent', kelvin: 2700 },
  bulb60: { label: '60 W bulb', type: 'point', amount: 60, unit: 'watt', lamp: 'incandescent', kelvin: 2700 },
  bulb100: { label: '100 W bulb', type: 'point', amount: 1600, unit: 'lumen', lamp: 'incandescent', kelvin: 2700 },
  led: { label: 'LED lamp, 8 W', type: 'point', amount: 8, unit: 'watt', lamp: 'led', kelvin: 3000 },
  halogenSpot: {
    label: 'Halogen spot, 50 W',
    type: 'spot',
    amount: 50,
    unit: 'watt',
    lamp: 'halogen',
    kelvin: 3000,
    shape: { cutoff: 18 * DEGREE, penumbra: 0.6, exponent: 0, range: 20 },
  },
  tube: {
    label: 'Fluorescent tube, 32 W',
    type: 'tube',
    amount: 32,
    unit: 'watt',
    lamp: 'fluorescent',
    kelvin: 4100,
    shape: { width: 1.2, height: 0.026 },
  },
  panel: {
    label: 'LED panel of an office',
    type: 'rectangle',
    amount: 3600,
    unit: 'lumen',
    lamp: 'led',
    kelvin: 4000,
    shape: { width: 0.6, height: 0.6 },
  },
  sodium: {
    label: 'Sodium street lamp',
    type: 'spot',
    amount: 9500,
    unit: 'lumen',
    kelvin: 2100,
    shape: { cutoff: 75 * DEGREE, penumbra: 0.5, exponent: 0, range: 40 },
  },
  floodlight: {
    label: 'Metal halide floodlight, 400 W',
    type: 'spot',
    amount: 36000,
    unit: 'lumen',
    kelvin: 4000,
    shape: { cutoff: 50 * DEGREE, penumbra: 0.4, exponent: 0, range: 100 },
  },
  headlamp: {
    label: 'Headlamp of a car',
    type: 'spot',
    amount: 1000,
    unit: 'lumen',
    lamp: 'halogen',
    kelvin: 3200,
    shape: { cutoff: 25 * DEGREE, penumbra: 0.5, exponent: 0, range: 100 },
  },
  sun: { label: 'Sun at noon', type: 'directional', amount: 100000, unit: 'lux', kelvin: 5500 },
  overcast: { label: 'Overcast sky', type: 'hemisphere', amount: 5000, unit: 'lux', kelvin: 6500 },
  fullMoon: { label: 'Full moon', type: 'directional', amount: 0.25, unit: 'lux', kelvin: 4100 },
};

/**
 * Values of a Light's fields by a preset.
 * @param light - present light; its shape is kept where the preset has none
 */
export function valuesOfPreset(
  { type, amount, unit, lamp = 'led', kelvin, shape }: LightPreset,
  light: PhotometricLight,
): Readonly<Record<string, number | string | null>> {
  const { cutoff, penumbra, exponent, width, height } = light;
  const values = { ...shape, type, lamp, profile: null };
  const shaped = { cutoff, penumbra, exponent, width, height, ...values };
  return {
    ...values,
    ...(type === 'point' || type === 'spot' ? { attenuation: 'physical', decay: 2 } : {}),
    intensityUnit: unit,
    intensity: amount / unitFactor(shaped, unit),
    colourBy: 'temperature',
    kelvin,
  };
}
