import { expect, it } from 'vitest';
import { addToNumber, stepFactor, suitsSlider, valueOnSlider } from './drag';
import { matchesFilter, wordsOfFilter } from './matchesFilter';

it('has a slider for ranges with two ends and few steps', () => {
  expect(suitsSlider({ min: 0, max: 1, step: 0.01 })).toBe(true);
  expect(suitsSlider({ min: 0, step: 0.01 })).toBe(false);
  expect(suitsSlider({ min: 0, max: 1000, step: 0.01 })).toBe(false);
});

it('goes by steps on a slider, and reaches both ends', () => {
  const range = { min: 0.05, max: 0.98, step: 0.1 };
  expect([-1, 0, 0.5, 1, 2].map((part) => valueOnSlider(part, range))).toEqual([0.05, 0.05, 0.5, 0.98, 0.98]);
  expect(valueOnSlider(0.5, range, true)).toBe(0.52);
});

it('adds without digits of rounding, within the range', () => {
  const range = { min: 0, max: 1, step: 0.1 };
  expect(addToNumber(0.7, 0.1, range)).toBe(0.8);
  expect(addToNumber(0.7, 5, range)).toBe(1);
  expect(addToNumber(0.7, -5, range)).toBe(0);
  expect(addToNumber(0.7, 0.01, range)).toBe(0.71);
  expect([stepFactor({ shiftKey: true, altKey: false }), stepFactor({ shiftKey: false, altKey: true })]).toEqual([
    10, 0.1,
  ]);
});

it('finds a field by words of its label, its name and its section, in any order', () => {
  const texts = ['Cast shadow', 'castShadow', 'Light'];
  expect(matchesFilter(wordsOfFilter(' shadow  LIGHT '), texts)).toBe(true);
  expect(matchesFilter(wordsOfFilter('shadow lamp'), texts)).toBe(false);
  expect(matchesFilter(wordsOfFilter('  '), texts)).toBe(true);
});
