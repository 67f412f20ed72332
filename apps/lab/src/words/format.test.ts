import { expect, test } from 'vitest';
import { formatBytes, formatDate, formatNumber } from './format';

test('dates are of this machine’s time zone; what is no date stays as it is', () => {
  // a time without a zone is local
  expect(formatDate('2026-11-22T18:11:00').replaceAll('\u202f', ' ')).toBe('Nov 22, 2026, 6:11 PM');
  expect(formatDate('once')).toBe('once');
});

test.each([
  [Number.NaN, '–'],
  [0, '0'],
  [0.0421, '0.0421'],
  [1.2549, '1.25'],
  [123.6, '124'],
  [1240.2, '1,240'],
])('%d is written %s', (value, text) => expect(formatNumber(value)).toBe(text));

test.each([
  [820, '820 B'],
  [1500, '1.5 kB'],
  [48_220_000, '48.2 MB'],
  [1_250_000_000, '1.25 GB'],
])('%d bytes are written %s', (value, text) => expect(formatBytes(value)).toBe(text));
