import { describe, expect, it } from 'vitest';
import { measureTurn } from './measureTurn';

/** A device with a simulated clock: calls take `cpu` ms, frames `gpu` ms in parallel, a wait at least `wait` ms. */
function device({ cpu = 0.2, gpu = 1, wait = 0.5, timer = true } = {}) {
  let clock = 0;
  let done = 0;
  let frames = 0;
  let waits = 0;
  const now = (): number => clock;
  const draw = (): number => {
    frames++;
    clock += cpu;
    done = Math.max(done, clock) + gpu;
    return cpu;
  };
  return {
    now,
    frame: draw,
    finish() {
      waits++;
      clock = Math.max(clock, done) + wait;
    },
    timer: timer
      ? {
          async time(count: number, frame: () => void) {
            for (let i = 0; i < count; i++) frame();
            clock = Math.max(clock, done);
            return Array.from({ length: count }, () => gpu);
          },
        }
      : null,
    counts: () => ({ frames, waits }),
  };
}

describe('measureTurn', () => {
  it('takes the wait off, and many frames as one sample', async () => {
    const { frame, cpu, gpu } = await measureTurn(device(), 400);
    // the GPU begins 0.2 ms after the first call, a delay shared by the frames of the batch
    for (const ms of frame) expect(ms).toBeCloseTo(1, 1);
    for (const ms of cpu) expect(ms).toBeCloseTo(0.2);
    expect(gpu).toEqual(gpu!.map(() => 1));
    expect(frame.length).toBeGreaterThanOrEqual(3);
    expect(frame.length).toBeLessThan(6);
  });

  it('has batches so long that the call of their first frame, for which the GPU waits, hardly counts', async () => {
    const { frame } = await measureTurn(device({ cpu: 2, gpu: 5 }), 900);
    for (const ms of frame) expect(Math.abs(ms - 5)).toBeLessThan(0.15);
  });

  it('is bound by the calls where those take longer', async () => {
    const { frame, cpu } = await measureTurn(device({ cpu: 3, gpu: 1 }), 200);
    for (const ms of frame) expect(ms).toBeCloseTo(3, 0);
    for (const ms of cpu) expect(ms).toBeCloseTo(3);
  });

  it('keeps to its time', async () => {
    for (const gpu of [0.01, 1, 10]) {
      const measured = device({ gpu });
      await measureTurn(measured, 300);
      expect(measured.now()).toBeGreaterThan(250);
      expect(measured.now()).toBeLessThan(450);
    }
  });

  it('has three samples of each kind where a frame takes seconds, and no more', async () => {
    const measured = device({ cpu: 10, gpu: 2000, wait: 1 });
    const { frame, cpu, gpu } = await measureTurn(measured, 100);
    expect([frame, cpu, gpu].map((samples) => samples!.length)).toEqual([3, 3, 3]);
    expect(frame[0]).toBeCloseTo(2010);
    expect(cpu[0]).toBe(10);
    // one frame to measure the length of a frame
    expect(measured.counts().frames).toBe(7);
  });

  it('says so where the device has no clock, or says that it was disturbed', async () => {
    expect((await measureTurn(device({ timer: false }), 60)).gpu).toBeNull();
    const disturbed = { ...device(), timer: { time: async () => [] } };
    let calls = 0;
    disturbed.now = () => ++calls * 5;
    expect((await measureTurn(disturbed, 60)).gpu).toBeNull();
  });
});
