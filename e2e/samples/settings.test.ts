/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { firstLanguage, type Language, languages } from '@farol/editing';
import { sunShadows } from '@farol/engine';
import { clearLearnt, type LearntChoice, learntChoices } from '@farol/renderer';
import { fogQualities, fogShapes } from '@farol/renderer/volumetric-fog';
import { expect, test } from 'vitest';

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
