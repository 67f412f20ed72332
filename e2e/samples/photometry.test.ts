/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { firstLanguage, languages } from '@farol/editing';
import { GameObject, Light, sunShadows } from '@farol/engine';
import {
  chromaticityOf,
  evOfCamera,
  exposureOfEV,
  HIGHEST_KELVIN,
  intensityUnits,
  lampEfficacies,
  lampKinds,
  lightOfKelvin,
  LOWEST_KELVIN,
  luminanceOf,
  shownIntensity,
  solidAngleOf,
  unitLabels,
  unitOfThree,
  unitSymbols,
} from '@farol/engine/photometry';
import { fogQualities, fogShapes } from '@farol/renderer/volumetric-fog';
import { expect, test } from 'vitest';

test('colour temperatures and exposure', () => {
  expect(luminanceOf(lightOfKelvin(2700))).toBeCloseTo(1);
  expect(chromaticityOf(6504)[0]).toBeCloseTo(0.31);
  expect(LOWEST_KELVIN).toBe(1000);
  expect(HIGHEST_KELVIN).toBe(25000);
  const ev = evOfCamera(16, 1 / 125, 100); // f/16, 1/125 s, ISO 100
  expect(ev).toBeCloseTo(14.966);
  expect(exposureOfEV(0)).toBeCloseTo(0.833);
});

test('units of light', () => {
  expect(unitOfThree('spot')).toBe('candela');
  expect(unitSymbols.lumen).toBe('lm');
  expect(unitLabels.lumen).toBe('Lumen (lm)');
  expect(intensityUnits).toContain('nits');
  expect(lampKinds).toContain('led');
  expect(lampEfficacies.led).toBe(100);

  const lamp = new GameObject('Lamp').addComponent(Light, { type: 'point', intensity: 5 });
  expect(solidAngleOf(lamp)).toBe(4 * Math.PI);
  expect(shownIntensity(lamp).symbol).toBe('cd');
});

test('suns and fog', () => {
  const sun = new GameObject('Sun');
  sun.addComponent(Light, { type: 'directional', castShadow: true, ...sunShadows(20) });
  expect(fogShapes).toContain('sphere');
  expect(fogQualities.low).toEqual([96, 54, 32]);
});

test('languages', () => {
  expect(firstLanguage(null, ['es-MX', 'en'])).toBe('es');
  expect(languages.es).toBe('Español');
});
