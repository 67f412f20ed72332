import { expect, test } from 'vitest';
import { PictureBudget } from './PictureBudget';

/** Simulates a bake whose parts take 10 ms each. @returns number of frames drawn, and their share of the time */
function play(pictureMilliseconds: number, milliseconds: number): { pictures: number; share: number } {
  const budget = new PictureBudget();
  let [now, pictures] = [0, 0];
  while (now < milliseconds) {
    const isDrawn = budget.isDue(now);
    if (isDrawn) pictures++;
    now += 10 + (isDrawn ? pictureMilliseconds : 0);
  }
  return { pictures, share: (pictures * pictureMilliseconds) / now };
}

test('a quick device draws four pictures a second, a slow one lets them take a fifth of the time', () => {
  expect(play(5, 10_000).pictures).toBeGreaterThan(35);
  expect(play(5, 10_000).pictures).toBeLessThanOrEqual(41);
  const slow = play(800, 60_000);
  expect(slow.pictures).toBeGreaterThan(10);
  expect(slow.share).toBeLessThan(0.22);
});
