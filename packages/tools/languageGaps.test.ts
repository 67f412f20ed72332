import { expect, test } from 'vitest';
import { languageGaps } from './languageGaps.mjs';

const entries = { lamp: ['Lamp', 'Shines.', 'Size'], toy: ['Toy', 'Rolls.', 'Size'] };

test('what stands outside of entries must be there, and an entry that is begun must be complete', () => {
  expect(languageGaps(['Add'], entries, { Lamp: 'Farol' })).toEqual(['Add', 'Shines.', 'Size']);
  expect(languageGaps(['Add'], entries, { Add: 'Sumar', Lamp: 'Farol', 'Shines.': 'Brilla.', Size: 'Talla' })).toEqual(
    [],
  );
});

test('an entry without a text of its own in the language is shown in English', () => {
  expect(languageGaps([], { toy: entries.toy }, {})).toEqual([]);
  // a text that others have too is not its own
  expect(languageGaps([], entries, { Lamp: 'Farol', 'Shines.': 'Brilla.', Size: 'Talla' })).toEqual([]);
  expect(languageGaps(['Size'], { toy: entries.toy }, {})).toEqual(['Size']);
  expect(languageGaps([], { toy: ['Size'], lamp: ['Size', 'Lamp'] }, { Lamp: 'Farol' })).toEqual(['Size']);
});
