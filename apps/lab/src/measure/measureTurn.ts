import type { Turn } from '../stage/Stage';
import type { GpuTimer } from './GpuTimer';
import { nextTask } from './nextTask';
import { median } from './spread';

/** A scene whose frames are measured, and the clock `now` (ms). */
export interface Measured {
  /** Moves the lights by one time step and draws a frame. @returns duration of the drawing call (ms) */
  frame(): number;
  /** Waits until the device has drawn everything. */
  finish(): void | Promise<void>;
  readonly timer: Pick<GpuTimer, 'time'> | null;
  now(): number;
}

/** Minimum duration of a sample (ms), which may be of several frames: browsers' clocks have steps of 0.1 ms. */
const SPAN = 20;
/**
 * Duration of a batch of frames on a GPU if the turn is long enough (ms): the GPU idles during the drawing call of a
 * batch's first frame, whose share is smaller in a longer batch.
 */
const GPU_SPAN = 100;
/** Minimum number of samples of each kind of time: throughput, CPU and GPU. */
const FEWEST = 3;
/** Number of frames with timer queries between two waits. */
const QUERIES = 8;

/**
 * Draws frames for about `ms` milliseconds: a few to warm up, then batches with one wait each for the throughput, single
 * frames with a wait each for the CPU time, and frames with timer queries for the GPU time.
 */
export async function measureTurn(measured: Measured, ms: number): Promise<Turn> {
  const { finish, timer, now } = measured;
  const wait = await waitCost(measured);
  const drawn = (): void => void measured.frame();
  // warms caches and clocks up; the duration of a frame determines the size of a batch
  let length = 0;
  const begin = now();
  do {
    const start = now();
    drawn();
    await finish();
    length = Math.max(now() - start - wait, 1e-3);
  } while (now() - begin < Math.min(ms / 10, SPAN));
  const kinds = timer ? 3 : 2;
  const share = ms / kinds;
  const span = timer ? Math.max(SPAN, Math.min(GPU_SPAN, share / FEWEST)) : SPAN;
  const batch = Math.max(1, Math.min(1000, Math.ceil(span / length)));

  const frame: number[] = [];
  const cpu: number[] = [];
  await repeat(now, share, async () => {
    const start = now();
    let calls = 0;
    for (let i = 0; i < batch; i++) calls += measured.frame();
    await finish();
    const whole = now() - start;
    frame.push(Math.max(whole - Math.min(wait, whole / 2), 0) / batch);
    // with one frame per batch the call never waits for an earlier frame: its time is the CPU time
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
      Math.ceil(FEWEST / queries),
    );
    await finish();
  }
  return { frame, cpu, gpu: gpu.length > 0 ? gpu : null };
}

/** Duration of a wait on an idle device (ms). */
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

/** Repeats `step` for about `ms` milliseconds, at least `minimum` times; other tasks of the page run in between. */
async function repeat(now: () => number, ms: number, step: () => Promise<void>, minimum = FEWEST): Promise<void> {
  const begin = now();
  for (let i = 0; i < minimum || now() - begin < ms; i++) {
    await step();
    await nextTask();
  }
}
