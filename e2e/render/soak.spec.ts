import { soakFaults, soakRounds } from '@farol/tools/soakRounds';
import { expect, test } from '../support/test';

// with the killed tabs of editor/kills.spec.ts about a minute; far more by hand: npm run soak -- --minutes 30
test.describe.configure({ timeout: 240_000 });

test('a renderer that goes through chaos draws what a fresh one draws, says nothing, and leaves nothing @verify', async ({
  page,
  pagesURL,
  watch,
}) => {
  const isOver = (rounds: number) => rounds >= 24;
  const result = await soakRounds(page, { url: pagesURL, seed: 5, every: 4, isOver });
  // `watch` tells the console of each loss, those of the soak included
  const faults = soakFaults(result).filter((fault) => !fault.startsWith('error: a WebGL context was lost'));
  expect(faults).toEqual([]);
  expect(result.left, 'GPU objects once all is disposed, less those that stock three keeps').toEqual({});
  // those that the soak takes away itself; all else is among the faults
  watch.forgive(/a WebGL context was lost|CONTEXT_LOST_WEBGL: loseContext|the view '[a-z-]+' shows the final picture/);
});
