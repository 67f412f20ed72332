import { expect, test } from 'vitest';
import { CaseMeter, collectGarbage } from './CaseMeter';

test('work and waiting are time; what another process takes of the machine is none', async () => {
  const working = await CaseMeter.begin(null);
  const { user, system } = process.cpuUsage();
  for (let now = process.cpuUsage(); now.user + now.system - user - system < 100_000;) now = process.cpuUsage();
  working.lap();
  expect(working.seconds).toBeGreaterThan(0.09);

  const waiting = await CaseMeter.begin(null);
  await new Promise((resolve) => void setTimeout(resolve, 200));
  waiting.lap();
  expect(waiting.seconds).toBeGreaterThan(0.15);

  // a thread that is stopped stands for one that gets no processor
  const stopped = await CaseMeter.begin(null);
  Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1000);
  stopped.lap();
  expect(stopped.seconds).toBeLessThan(0.8);

  const twice = await CaseMeter.begin(null);
  for (let lap = 0; lap < 2; lap++) {
    await new Promise((resolve) => void setTimeout(resolve, 200));
    twice.lap();
  }
  expect(twice.seconds, 'of the longest lap').toBeGreaterThan(0.15);
  expect(twice.seconds, 'of the longest lap').toBeLessThan(0.35);
});

test('memory in use is measured, not garbage; a collection meanwhile is told of', async () => {
  const size = 2 ** 20;
  const alone = await CaseMeter.begin(collectGarbage);
  const kept = Array.from({ length: size }, (_, i) => [i]);
  for (let i = 0; i < 10; i++) Array.from({ length: size }, (_, j) => [j]);
  alone.lap();
  // an array of one number takes 56 bytes, and 8 in the list; ten times as much is garbage
  expect(alone.memory / size).toBeGreaterThan(56);
  expect(alone.memory / size).toBeLessThan(72);
  expect(alone.isBlurred).toBe(false);

  const calm = await CaseMeter.begin(null);
  calm.lap();
  expect(calm.isBlurred).toBe(false);

  kept.length = 0;
  const blurred = await CaseMeter.begin(null);
  collectGarbage();
  blurred.lap();
  expect(blurred.isBlurred).toBe(true);
});
