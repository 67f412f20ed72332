import { soakFaults, soakRounds } from '@farol/tools/soakRounds';
import { expect, test } from '../support/test';

// far more by hand: npm run soak -- --minutes 30
test('a renderer that goes through chaos draws what a fresh one draws, and says nothing', async ({
  page,
  pagesURL,
  watch,
}) => {
  const without = (process.env.FAROL_SOAK_WITHOUT ?? '').split(',').filter(Boolean);
  const isOver = (rounds: number) => rounds >= 8;
  const result = await soakRounds(page, { url: pagesURL, seed: 5, every: 4, isOver, without });
  expect(soakFaults(result)).toEqual([]);
  console.log(`GPU objects once all is disposed: ${JSON.stringify(result.left)}`);
  // those that the soak takes away itself; all else is among the faults
  watch.forgive(/a WebGL context was lost|CONTEXT_LOST_WEBGL: loseContext/);
});
