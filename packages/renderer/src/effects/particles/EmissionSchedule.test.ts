import { expect, test } from 'vitest';
import { EmissionSchedule, LONGEST_STEP, type SimulationStep } from './EmissionSchedule';
import { particleDefaults } from './particleDefaults';
import type { ParticleSettings } from './ParticleSettings';

function run(settings: Partial<ParticleSettings>, steps: readonly number[], emits = true) {
  const schedule = new EmissionSchedule();
  const taken: SimulationStep[] = [];
  for (const seconds of steps)
    schedule.advance(seconds, { ...particleDefaults, ...settings }, emits, (step) => taken.push({ ...step }));
  return { schedule, taken };
}

const repeat = (seconds: number, times: number) => Array<number>(times).fill(seconds);
/** When each particle began. */
const births = (taken: readonly SimulationStep[]) =>
  taken.flatMap(({ time, seconds, bursting, rated, offset, interval }) => [
    ...repeat(time - seconds, bursting),
    ...Array.from({ length: rated }, (_, i) => time - seconds + offset + i * interval),
  ]);

test('a rate gives particles at equal times, however the time is cut', () => {
  const wanted = Array.from({ length: 20 }, (_, i) => (i + 1) / 20);
  for (const steps of [repeat(1, 1), repeat(1 / 60, 60), [0.013, 0.5, 0.2, 0.287]]) {
    const { taken, schedule } = run({ rate: 20 }, steps);
    const close = births(taken);
    expect(close).toHaveLength(20);
    close.forEach((time, i) => expect(time).toBeCloseTo(wanted[i], 6));
    expect(schedule.time).toBeCloseTo(1, 9);
    expect(taken.every(({ seconds }) => seconds <= LONGEST_STEP + 1e-9)).toBe(true);
  }
});

test('bursts come at their times, once, or in each loop', () => {
  const bursts = [
    { time: 0.1, count: 5 },
    { time: 0, count: 3 },
  ];
  const once = births(run({ rate: 0, bursts, duration: 0.4, loop: false }, repeat(0.07, 20)).taken);
  expect(once.map((time) => Math.round(time * 1000))).toEqual([0, 0, 0, 100, 100, 100, 100, 100]);
  const looped = births(run({ rate: 0, bursts, duration: 0.4 }, repeat(0.07, 10)).taken);
  expect(looped.map((time) => Math.round(time * 1000))).toEqual([
    ...[0, 0, 0, 100, 100, 100, 100, 100],
    ...[400, 400, 400, 500, 500, 500, 500, 500],
  ]);
});

test('without a loop it is over after its duration; while nothing is emitted, nothing begins', () => {
  const { schedule, taken } = run({ rate: 100, duration: 0.5, loop: false }, repeat(0.1, 10));
  expect(schedule.isOver).toBe(true);
  expect(births(taken)).toHaveLength(50);
  expect(births(run({ rate: 100, bursts: [{ time: 0, count: 9 }] }, repeat(0.1, 10), false).taken)).toEqual([]);
});

test('no more than its capacity live at once; when the oldest have ended, there is room again', () => {
  const { schedule, taken } = run({ capacity: 30, rate: 100, life: [0.2, 0.5] }, repeat(0.1, 20));
  expect(schedule.begun - schedule.oldest).toBeLessThanOrEqual(30);
  expect(schedule.begun).toBeGreaterThan(90);
  let before = 0;
  for (const { first, bursting, rated } of taken) {
    expect(first).toBe(before);
    before = first + bursting + rated;
  }
  expect(before).toBe(schedule.begun);
});

test('a restart begins with the first burst again', () => {
  const { schedule } = run({ rate: 10, bursts: [{ time: 0, count: 4 }] }, [0.5]);
  schedule.restart();
  expect([schedule.time, schedule.begun, schedule.oldest]).toEqual([0, 0, 0]);
  let begun = 0;
  schedule.advance(0.05, { ...particleDefaults, rate: 0, bursts: [{ time: 0, count: 4 }] }, true, (step) => {
    begun += step.bursting;
  });
  expect(begun).toBe(4);
});

test('a delay lets particles, bursts and the duration begin later, once', () => {
  const settings = { rate: 10, bursts: [{ time: 0.1, count: 2 }], delay: 0.35, duration: 0.5 };
  const wanted = [0.1, 0.1, 0.1, 0.2, 0.3, 0.4, 0.5].map((time) => 0.35 + time);
  for (const steps of [repeat(0.425, 2), repeat(1 / 60, 51)]) {
    const close = births(run({ ...settings, loop: false }, steps).taken).toSorted((a, b) => a - b);
    expect(close).toHaveLength(wanted.length);
    close.forEach((time, i) => expect(time).toBeCloseTo(wanted[i], 6));
  }
  const looped = births(run({ ...settings, rate: 0 }, repeat(0.05, 30)).taken);
  [0.45, 0.45, 0.95, 0.95, 1.45, 1.45].forEach((time, i) => expect(looped[i]).toBeCloseTo(time, 6));
});

test('it is known that particles could not begin for want of room', () => {
  expect(run({ capacity: 21, rate: 10, life: [1, 2] }, repeat(0.1, 60)).schedule.wasFull).toBe(false);
  expect(run({ capacity: 19, rate: 10, life: [1, 2] }, repeat(0.1, 60)).schedule.wasFull).toBe(true);
  expect(run({ capacity: 19, rate: 10, life: [1, 2] }, repeat(0.1, 60), false).schedule.wasFull).toBe(false);
});
