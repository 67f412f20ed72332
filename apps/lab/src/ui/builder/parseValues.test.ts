import { expect, test } from 'vitest';
import { parseValues } from './parseValues';

test.each([
  ['10, 100, 1000', [10, 100, 1000]],
  ['1000 10;100', [10, 100, 1000]],
  [' 5,5, 5 ', [5]],
  ['1k, 2.5k', [1000, 2500]],
  ['0', [0]],
])('%j gives %j', (text, values) => expect(parseValues(text)).toEqual({ values }));

test.each([
  ['', /at least/],
  [' , ', /at least/],
  ['10, ten', /“ten” is no whole number/],
  ['-4', /“-4” is no whole number/],
  ['1.5', /“1.5” is no whole number/],
  ['2000000', /a million at most/],
  [Array.from({ length: 21 }, (_, i) => i).join(), /21 values are too many/],
])('%j is refused', (text, problem) => expect(parseValues(text)).toEqual({ problem: expect.stringMatching(problem) }));
