import { soakFaults, soakRounds } from '@farol/tools/soakRounds';
import { expect, test } from '../support/test';

// far more by hand: npm run soak -- --minutes 30
test('a renderer that goes through chaos draws what a fresh one draws, says nothing, and leaves nothing', async ({
  page,
  pagesURL,
  watch,
}) => {
  const without = (process.env.FAROL_SOAK_WITHOUT ?? '').split(',').filter(Boolean);
  const isOver = (rounds: number) => rounds >= 8;
  const result = await soakRounds(page, { url: pagesURL, seed: 5, every: 4, isOver, without });
  expect(soakFaults(result)).toEqual([]);
  expect(result.left, 'GPU objects once all is disposed, less those that stock three keeps').toEqual({});
  // those that the soak takes away itself; all else is among the faults
  watch.forgive(/a WebGL context was lost|CONTEXT_LOST_WEBGL: loseContext/);
});
