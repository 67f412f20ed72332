import { expect, test } from 'vitest';
import { formatBytes, formatNumber } from './formatNumber';

test.each([
  [0, '0'],
  [0.0004, '< 0.001'],
  [0.0421, '0.042'],
  [1.2549, '1.25'],
  [16.68, '16.7'],
  [123.6, '124'],
  [1240.2, '1,240'],
])('%d is written %s', (value, text) => expect(formatNumber(value)).toBe(text));

test.each([
  [820, '820 B'],
  [1500, '1.5 kB'],
  [48_220_000, '48.2 MB'],
  [1_250_000_000, '1.25 GB'],
])('%d bytes are written %s', (value, text) => expect(formatBytes(value)).toBe(text));
