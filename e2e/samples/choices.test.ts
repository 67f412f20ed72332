/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { firstLanguage, languages } from '@farol/editing';
import { fogQualities, fogShapes } from '@farol/renderer/volumetric-fog';
import { expect, test } from 'vitest';

test('fog', () => {
  expect(fogShapes).toContain('sphere');
  expect(fogQualities.low).toEqual([96, 54, 32]);
});

test('the language to begin with', () => {
  expect(firstLanguage(null, ['es-MX', 'en'])).toBe('es');
  expect(languages.es).toBe('Español');
});
