/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { GameObject, Light, sunShadows } from '@farol/engine';
import {
  colourOfKelvin,
  evOfCamera,
  evOfIlluminance,
  evOfLuminance,
  exposureOfEV,
  formatIntensity,
  lampEfficacies,
  lampKinds,
  lightOfKelvin,
  lightPresets,
  shownIntensity,
  shownUnit,
  unitFactor,
  unitLabels,
  unitsFor,
  valuesOfPreset,
} from '@farol/engine/photometry';
import { expect, test } from 'vitest';

test('lights in their units', () => {
  const light = new GameObject('Bulb').addComponent(Light, { intensity: 10, lamp: 'halogen' });
  expect(unitsFor(light)).toEqual(['candela', 'lumen', 'lux', 'watt']);
  expect(unitFactor(light, 'lumen')).toBe(4 * Math.PI);
  expect(shownUnit(light)).toBe('candela');
  light.intensityUnit = 'watt';
  expect(formatIntensity(light)).toBe('6.347 W');
  const { symbol, factor } = shownIntensity(light);
  expect([symbol, factor]).toEqual(['W', (4 * Math.PI) / lampEfficacies.halogen]);
  expect(unitLabels.watt).toBe('Watt (W)');
  expect(lampKinds).toEqual(['incandescent', 'halogen', 'fluorescent', 'led']);
});

test('presets', () => {
  const light = new GameObject('Candle').addComponent(Light);
  const values = valuesOfPreset(lightPresets.candle, light);
  for (const [name, value] of Object.entries(values)) light.set(name, value);
  expect(formatIntensity(light)).toBe('1 cd');
});

test('colours and exposure', () => {
  const [red, green, blue] = colourOfKelvin(2700);
  expect([red, green > 0.41, blue < 0.1]).toEqual([1, true, true]);
  expect(Math.max(...lightOfKelvin(2700))).toBeGreaterThan(1);
  expect(evOfLuminance(4096)).toBe(15);
  expect(evOfIlluminance(81_920)).toBe(15);
  const ev = evOfCamera(16, 1 / 128, 100);
  expect(ev).toBe(15);
  expect(exposureOfEV(0)).toBe(1 / 1.2);
});

test('shadows of a sun', () => {
  const sun = new GameObject('Sun').addComponent(Light, { type: 'directional', ...sunShadows(50) });
  expect(sun.shadowExtent).toBe(50);
});
