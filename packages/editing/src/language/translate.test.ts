import { afterEach, expect, test } from 'vitest';
import { formatCount } from './formatCount';
import { formatTime } from './formatTime';
import { setTexts, t, tCount } from './translate';

afterEach(() => setTexts({}));

test('a text is that of the language, with its values, and the English one where the language has none', () => {
  expect(t('Box {number}', { number: 2 })).toBe('Box 2');
  setTexts({ 'Box {number}': 'Caja {number}', '{count} lights': '{count} luces' });
  expect(t('Box {number}', { number: 2 })).toBe('Caja 2');
  expect(t('Sphere')).toBe('Sphere');
  expect(t('toString')).toBe('toString');
  expect(t('Box {number}', {})).toBe('Caja {number}');
  expect(t('Scale##verb')).toBe('Scale');
  expect([tCount(2, '{count} light', '{count} lights'), tCount(1, '{count} light', '{count} lights')]).toEqual([
    '2 luces',
    '1 light',
  ]);
});

test('times are of the language that is shown', () => {
  const noon = new Date(2026, 0, 31, 12, 5, 9).getTime();
  setTexts({}, 'es');
  expect(formatTime(noon)).toBe('12:05:09');
  expect(formatTime(noon, true)).toMatch(/^31 ene 2026/);
  setTexts({});
  expect(formatTime(noon, true)).toMatch(/^Jan 31, 2026/);
});

test('thousands are apart by what is no decimal point in the language that is shown', () => {
  expect([formatCount(2208.4), formatCount(151_700, true), formatCount(12)]).toEqual(['2,208', '151.7K', '12']);
  setTexts({}, 'es');
  expect([formatCount(1_002_208), formatCount(151_700, true)]).toEqual(['1\u202f002\u202f208', '151.7K']);
});
