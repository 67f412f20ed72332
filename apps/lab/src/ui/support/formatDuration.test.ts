import { expect, test } from 'vitest';
import { formatDuration, roughDuration } from './formatDuration';

test.each([
  [0, '0 s'],
  [-5, '0 s'],
  [8400, '8 s'],
  [59_400, '59 s'],
  [59_600, '1 min'],
  [80_000, '1 min 20 s'],
  [3_599_000, '59 min 59 s'],
  [3_600_000, '1 h'],
  [7_500_000, '2 h 5 min'],
  [7_190_000, '2 h'],
])('%d ms is %s', (ms, words) => expect(formatDuration(ms)).toBe(words));

test.each([
  [400, '0 s'],
  [8400, '8 s'],
  [83_000, '1 min 20 s'],
  [118_000, '2 min'],
  [217_000, '4 min'],
  [456_000, '8 min'],
])('%d ms is about %s', (ms, words) => expect(roughDuration(ms)).toBe(words));
