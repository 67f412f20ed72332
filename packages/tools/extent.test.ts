import { expect, test } from 'vitest';
import { readExtent } from './extent.mjs';

test('the extent of the tests is the slice, or what FAROL_TESTS names', () => {
  expect([undefined, '', 'slice', 'verify', 'long'].map(readExtent)).toEqual([
    'slice',
    'slice',
    'slice',
    'verify',
    'long',
  ]);
  expect(() => readExtent('all')).toThrow('FAROL_TESTS is "all": it can be slice, verify, long.');
});
