import { expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { createFractalNoise, createNoise } from './createNoise';

const noises = { 'of 7 cells': createNoise(7, 3), 'of 4 octaves': createFractalNoise(5, 4, 11, 0.6) };

test.each(Object.entries(noises))('noise %s is smooth and repeats in x and y, from 0 to below 1', (_, noise) => {
  const random = createRandom(1);
  const [cells, tiny] = [280, 1e-7];
  let [jump, repeat, least, most] = [0, 0, 1, 0];
  for (let i = 0; i < 5000; i++) {
    // points on cell borders and between them, in the whole plane
    const [x, y] = [random(), random()].map((each) => Math.round(each * 3 * cells) / cells - 1 + (i % 2) * random());
    const value = noise(x, y);
    for (const other of [noise(x - tiny, y), noise(x, y - tiny)]) jump = Math.max(jump, Math.abs(other - value));
    for (const other of [noise(x + 1, y), noise(x, y + 1)]) repeat = Math.max(repeat, Math.abs(other - value));
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  expect(jump).toBeLessThan(1e-5);
  expect(repeat).toBeLessThan(1e-9);
  expect(least).toBeGreaterThanOrEqual(0);
  expect(most).toBeLessThan(1);
  expect(most - least).toBeGreaterThan(0.5);
});
