/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { firstLanguage, type Language, languages } from '@farol/editing';
import { sunShadows } from '@farol/engine';
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
  type ShownIntensity,
  shownIntensity,
  solidAngleOf,
  unitLabels,
  unitOfThree,
  unitSymbols,
} from '@farol/engine/photometry';
import { clearLearnt, type LearntChoice, learntChoices } from '@farol/renderer';
import { fogQualities, fogShapes } from '@farol/renderer/volumetric-fog';
import { expect, test } from 'vitest';

/** A bulb whose light is the same in every direction. */
const bulb = {
  ...{ type: 'point', cutoff: 0.5, penumbra: 0, exponent: 0, width: 0, height: 0 },
  ...{ intensity: 800 / (4 * Math.PI), intensityUnit: 'lumen', lamp: 'led' },
} as const;

test('units of light', () => {
  const shown: ShownIntensity = shownIntensity(bulb);
  expect(shown).toEqual({ value: 800, symbol: 'lm', factor: 4 * Math.PI });
  expect(solidAngleOf(bulb)).toBe(4 * Math.PI);
  expect(unitOfThree('rectangle')).toBe('nits');
  expect(intensityUnits.map((unit) => unitSymbols[unit])).toEqual(['cd', 'lm', 'lx', 'nt', 'W']);
  expect(unitLabels.lux).toBe('Lux (lx)');
  expect(lampKinds.map((kind) => 60 * lampEfficacies[kind])).toEqual([870, 1200, 5400, 6000]);
});

test('colour temperature', () => {
  const [x, y] = chromaticityOf(6500);
  expect([x.toFixed(3), y.toFixed(3)]).toEqual(['0.313', '0.329']);
  expect(luminanceOf(lightOfKelvin(2700)).toFixed(3)).toBe('1.000');
  expect([LOWEST_KELVIN, HIGHEST_KELVIN]).toEqual([1000, 25000]);
});

test('exposure', () => {
  expect(evOfCamera(16, 1 / 125, 100).toFixed(2)).toBe('14.97');
  expect(exposureOfEV(0).toFixed(3)).toBe('0.833');
});

test('shadows of a sun over a square of 100 m', () => {
  expect(sunShadows(50).shadowExtent).toBe(50);
});

test('languages of the apps', () => {
  const language: Language = firstLanguage(null, ['es-UY', 'en']);
  expect(languages[language]).toBe('Español');
});

test('fog', () => {
  expect(fogQualities.medium).toEqual([160, 90, 64]);
  expect(fogShapes).toEqual(['box', 'sphere']);
});

test('verdicts that auto has learnt', async () => {
  await clearLearnt();
  const choices: LearntChoice[] = await learntChoices();
  expect(choices).toEqual([]);
});
