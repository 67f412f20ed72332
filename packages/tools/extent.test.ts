import { expect, test } from 'vitest';
import { extentOf } from './extent.mjs';

test('FAROL_TESTS names an extent, and none is the slice', () => {
  expect([undefined, 'slice', 'verify', 'long'].map((value) => extentOf(value))).toEqual([
    'slice',
    'slice',
    'verify',
    'long',
  ]);
});

test.each(['', 'whole', '1', 'Verify'])('FAROL_TESTS="%s" is refused with the values that there are', (value) => {
  expect(() => extentOf(value)).toThrow(`FAROL_TESTS is "${value}": set it to slice, verify, long, or leave it unset`);
});
