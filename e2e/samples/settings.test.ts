/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { firstLanguage, type Language, languages } from '@farol/editing';
import { fogQualities, fogShapes } from '@farol/renderer/volumetric-fog';
import { expect, test } from 'vitest';

test('languages of the apps', () => {
  const language: Language = firstLanguage(null, ['es-UY', 'en']);
  expect(languages[language]).toBe('Español');
});

test('fog', () => {
  expect(fogQualities.medium).toEqual([160, 90, 64]);
  expect(fogShapes).toEqual(['box', 'sphere']);
});
