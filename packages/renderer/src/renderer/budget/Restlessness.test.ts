import { expect, it } from 'vitest';
import { checkBudget } from '../FrameBudget';
import type { BudgetSource } from '../FrameBudget';
import { BudgetController } from './BudgetController';

/** Numbers from 0 to 1 by a fixed seed (mulberry32). */
function randomNumbers(seed: number): () => number {
  let a = seed;
  return () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Other work of a machine, which slows frames for a while. */
interface Bursts {
  /** Factor on the time of frames. */
  factor: number;
  /** Mean length of a burst, and of the pause after it (frames). */
  on: number;
  off: number;
  /** Standard deviation of the logarithm of times. */
  noise: number;
}

/** A rasteriser of 22 ms a frame at full scale, one frame in fifty three times as long, under bursts of other work. */
function simulate(bursts: Bursts, source: BudgetSource, seed: number) {
  const controller = new BudgetController(checkBudget({ frame: 16.7, min: 0.4 }));
  const random = randomNumbers(seed);
  const deviation = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
  const waiting: { scale: number; ms: number }[] = [];
  const load = { pixels: 18, rest: 4, bursts: true };
  let isBusy = false;
  /** @returns distance between the largest and the least scale, in steps */
  const draw = (frames: number): number => {
    let [low, high] = [1, 0];
    for (let i = 0; i < frames; i++) {
      if (random() < 1 / (isBusy ? bursts.on : bursts.off)) isBusy = !isBusy;
      const scale = controller.advance();
      [low, high] = [Math.min(low, scale), Math.max(high, scale)];
      const factor = (isBusy && load.bursts ? bursts.factor : 1) * (random() < 0.02 ? 3 : 1);
      waiting.push({
        scale,
        ms: (load.rest + load.pixels * scale ** 2) * factor * Math.exp(bursts.noise * deviation()),
      });
      while (waiting.length > (source === 'gpu' ? 3 : 1)) {
        const { scale, ms } = waiting.shift()!;
        controller.add(scale, ms, source);
      }
    }
    return (high - low) * 64;
  };
  return { controller, load, draw };
}

const loads: [string, Bursts][] = [
  ['short bursts of half as long again', { factor: 1.6, on: 15, off: 25, noise: 0.15 }],
  ['bursts of a second', { factor: 1.6, on: 40, off: 60, noise: 0.15 }],
  ['slight bursts', { factor: 1.3, on: 15, off: 25, noise: 0.1 }],
];

for (const source of ['gpu', 'interval'] as const)
  it.each(loads)(
    `by ${source} times, under %s, the scale comes to rest: mostly no sway at all, and seldom of more than a step or two`,
    (_, bursts) => {
      const sways: number[] = [];
      for (let seed = 1; seed <= 6; seed++) {
        const { draw } = simulate(bursts, source, seed);
        draw(600);
        for (let window = 0; window < 10; window++) sways.push(draw(120));
      }
      const sorted = sways.toSorted((a, b) => a - b);
      expect(sorted[sways.length / 2]).toBe(0);
      expect(sorted[0.9 * sways.length - 1]).toBeLessThanOrEqual(2.001);
    },
  );

for (const source of ['gpu', 'interval'] as const)
  it(`by ${source} times, a load that is gone for good is found out`, () => {
    for (let seed = 1; seed <= 6; seed++) {
      const { controller, load, draw } = simulate(loads[0][1], source, seed);
      draw(1200);
      expect(controller.scale).toBeLessThan(0.8);
      Object.assign(load, { pixels: 6, bursts: false });
      draw(1000);
      expect.soft(controller.scale, `seed ${seed}`).toBeGreaterThan(0.95);
    }
  });

for (const source of ['gpu', 'interval'] as const)
  it.each([0.05, 0.1])(
    `by ${source} times with noise of %f, one frame in fifty three times as long: a load that doubles and halves is held within 2 ms after 30 frames, without a sway of more than a step`,
    (noise) => {
      const sways: number[] = [];
      const off: number[] = [];
      for (let seed = 1; seed <= 12; seed++) {
        const { controller, load, draw } = simulate({ factor: 1, on: 1, off: 1, noise }, source, seed);
        Object.assign(load, { pixels: 12, rest: 3 });
        draw(60);
        for (const factor of [2, 1, 2, 1]) {
          Object.assign(load, { pixels: 12 * factor, rest: 3 * factor });
          draw(30);
          const ms = load.rest + load.pixels * controller.scale ** 2;
          // at the largest scale a frame may be faster
          off.push(controller.scale < 1 ? Math.abs(ms - 16.7) : Math.max(0, ms - 16.7));
          draw(30);
          sways.push(draw(120));
        }
      }
      // with noise of 10%, means of so few frames deviate more
      const share = noise < 0.1 ? 0 : 0.03;
      const late = off.filter((ms) => ms >= 2);
      expect(late.length, `off by ${late.join()} ms`).toBeLessThanOrEqual(share * off.length);
      const more = sways.filter((sway) => sway > 1.001);
      expect(more.length, `sways of ${more.join()} steps`).toBeLessThanOrEqual(share * sways.length);
    },
  );
