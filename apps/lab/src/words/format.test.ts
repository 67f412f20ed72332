import { expect, test } from 'vitest';
import { formatDate } from './format';

test('dates are of this machine’s time zone; what is no date stays as it is', () => {
  // without a zone it is local time
  expect(formatDate('2026-11-22T18:11:00').replaceAll('\u202f', ' ')).toBe('Nov 22, 2026, 6:11 PM');
  expect(formatDate('once')).toBe('once');
});
