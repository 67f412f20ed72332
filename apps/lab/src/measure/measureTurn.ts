import type { Turn } from '../stage/Stage';
import type { GpuTimer } from './GpuTimer';
import { nextTask } from './nextTask';
import { median } from './spread';

/** What is measured. Times come from `now` (ms). */
export interface Measured {
  /** Moves the lights by a step and draws a frame; says how long the drawing call took (ms). */
  frame(): number;
  /** Waits until all that was drawn is done. */
  finish(): void | Promise<void>;
  readonly timer: Pick<GpuTimer, 'time'> | null;
  now(): number;
}

/** A sample spans so much time at least, where frames are short (ms): browsers' clocks have steps of 0.1 ms. */
const SPAN = 20;
/** Samples of each kind, at least. */
const LEAST = 3;
/** Frames whose GPU times are asked for at once. */
const QUERIES = 8;

/**
 * Draws frames for about `ms` (ms): a few to warm up, then throughput in batches with one wait each, CPU time in frames
 * that are waited for one by one, and GPU times.
 */
export async function measureTurn(measured: Measured, ms: number): Promise<Turn> {
  const { finish, timer, now } = measured;
  const wait = await waitCost(measured);
  const drawn = (): void => void measured.frame();
  // caches filled, clocks up; how long a frame takes tells how many make a batch
  let length = 0;
  const begin = now();
  do {
    const start = now();
    drawn();
    await finish();
    length = Math.max(now() - start - wait, 1e-3);
  } while (now() - begin < Math.min(ms / 10, SPAN));
  const batch = Math.max(1, Math.min(1000, Math.ceil(SPAN / length)));
  const kinds = timer ? 3 : 2;
  const share = ms / kinds;

  const frame: number[] = [];
  const cpu: number[] = [];
  await repeat(now, share, async () => {
    const start = now();
    let calls = 0;
    for (let i = 0; i < batch; i++) calls += measured.frame();
    await finish();
    const whole = now() - start;
    frame.push(Math.max(whole - Math.min(wait, whole / 2), 0) / batch);
    // with one frame at a time the call never waits for an earlier frame
    if (batch === 1) cpu.push(calls);
  });
  if (batch > 1) {
    await repeat(now, share, async () => {
      let calls = 0;
      const start = now();
      let count = 0;
      for (; count < batch && now() - start < SPAN; count++) {
        calls += measured.frame();
        await finish();
      }
      cpu.push(calls / count);
    });
  }
  const gpu: number[] = [];
  if (timer) {
    const queries = Math.max(1, Math.min(QUERIES, batch));
    await repeat(
      now,
      share,
      async () => void gpu.push(...(await timer.time(queries, drawn))),
      Math.ceil(LEAST / queries),
    );
    await finish();
  }
  return { frame, cpu, gpu: gpu.length > 0 ? gpu : null };
}

/** Cost of a wait when there is nothing to wait for (ms). */
async function waitCost({ finish, now }: Measured): Promise<number> {
  await finish();
  const costs: number[] = [];
  for (let i = 0; i < 7; i++) {
    const start = now();
    await finish();
    costs.push(now() - start);
  }
  return median(costs);
}

/** Does `step` for about `ms` (ms), `least` times at least; other tasks of the page run in between. */
async function repeat(now: () => number, ms: number, step: () => Promise<void>, least = LEAST): Promise<void> {
  const begin = now();
  for (let i = 0; i < least || now() - begin < ms; i++) {
    await step();
    await nextTask();
  }
}
