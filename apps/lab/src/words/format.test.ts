import { expect, test } from 'vitest';
import { formatDate, formatMsRange } from './format';

test('dates are of this machine’s time zone; what is no date stays as it is', () => {
  // without a zone it is local time
  expect(formatDate('2026-11-22T18:11:00').replaceAll('\u202f', ' ')).toBe('Nov 22, 2026, 6:11 PM');
  expect(formatDate('once')).toBe('once');
});

test('a range of times that read the same is one time', () => {
  expect(formatMsRange([0.2471, 0.2474])).toBe('0.247 ms');
  expect(formatMsRange([2, 1, 3])).toBe('1 ms to 3 ms');
});
