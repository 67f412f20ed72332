import { describe, expect, it } from 'vitest';
import { checkBudget } from '../FrameBudget';
import { BudgetController } from './BudgetController';
import { REASONS } from './reasons';

const FRAME = 16.7;
/** Number of random seeds with which each device is simulated. */
const SEEDS = 6;

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

interface Device {
  /** Cost of the pixels at scale 1 (ms). */
  pixels: number;
  /** Cost that does not depend on the scale (ms). */
  rest: number;
  /** Standard deviation of times, as a share. */
  noise: number;
  /** Number of frames until a frame's time is known. */
  delay: number;
  /** Refresh interval of the display, to whose multiples intervals are rounded up (ms); 0: intervals equal frame times. */
  refresh: number;
}

/** A device that draws frames by a controller. */
function simulate(controller: BudgetController, device: Device, source: 'gpu' | 'interval', seed = 7) {
  const random = randomNumbers(seed);
  /** Normally distributed (Box and Muller 1958). */
  const deviation = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
  const waiting: { scale: number; ms: number }[] = [];
  const scales: number[] = [];
  const cost = (scale: number) => device.rest + device.pixels * scale * scale;
  const draw = (frames: number) => {
    for (let i = 0; i < frames; i++) {
      const scale = controller.advance();
      scales.push(scale);
      let ms = cost(scale) * (1 + device.noise * deviation());
      if (device.refresh > 0) ms = Math.max(1, Math.ceil(ms / device.refresh)) * device.refresh;
      waiting.push({ scale, ms });
      while (waiting.length > device.delay) {
        const { scale, ms } = waiting.shift()!;
        controller.add(scale, ms, source);
      }
    }
    return cost(controller.scale);
  };
  /** Distance between the largest and the least scale of the next frames, in steps of 1/64. */
  const sway = (frames: number) => {
    scales.length = 0;
    draw(frames);
    return (Math.max(...scales) - Math.min(...scales)) * 64;
  };
  return { draw, sway };
}

const budgetOf = (rest: object = {}) => new BudgetController(checkBudget({ frame: FRAME, min: 0.4, ...rest }));
const device = (rest: Partial<Device>): Device => ({ pixels: 10, rest: 0, noise: 0.05, delay: 4, refresh: 0, ...rest });

const noises = [0.01, 0.02, 0.05, 0.1];

const devices: [string, 'gpu' | 'interval', Device, number[]][] = [
  ['a GPU whose time goes with pixels', 'gpu', device({ pixels: 16 }), noises],
  ['a GPU with a quarter of its time beside pixels', 'gpu', device({ pixels: 12, rest: 4 }), noises],
  ['a GPU whose times come at once', 'gpu', device({ pixels: 14, rest: 1, delay: 1 }), noises],
  ['a rasteriser without a display', 'interval', device({ pixels: 16, delay: 1 }), noises],
  [
    'a rasteriser with a quarter of its time beside pixels',
    'interval',
    device({ pixels: 12, rest: 4, delay: 1 }),
    [0.01, 0.02, 0.05],
  ],
];

for (const [name, source, parts, noises] of devices) {
  it.each(noises)(
    `${name}, times with noise of %f: within 2 ms of the budget 30 frames after the load doubled and halved, and no sway of more than a step`,
    (noise) => {
      for (let seed = 1; seed <= SEEDS; seed++) {
        const controller = budgetOf();
        const load = { ...parts, noise };
        const { draw, sway } = simulate(controller, load, source, seed);
        draw(60);
        for (const factor of [2, 1, 2, 1]) {
          Object.assign(load, { pixels: parts.pixels * factor, rest: parts.rest * factor });
          const ms = draw(30);
          const said = `seed ${seed}, load × ${factor}`;
          expect.soft(ms, said).toBeLessThan(FRAME + 2);
          // at the largest scale a frame may be faster
          if (controller.scale < 1) expect.soft(ms, said).toBeGreaterThan(FRAME - 2);
          draw(30);
          expect.soft(sway(120), `${said}: sway (steps)`).toBeLessThanOrEqual(1.001);
        }
      }
    },
  );
}

describe('BudgetController', () => {
  it('holds intervals of a display, tries larger scales ever more seldom, and finds the largest when the load is gone', () => {
    const controller = budgetOf();
    const load = device({ pixels: 14, delay: 1, noise: 0.006, refresh: 16.67 });
    const { draw, sway } = simulate(controller, load, 'interval');
    draw(60);
    expect(controller.scale).toBe(1);
    load.pixels = 28;
    expect(draw(30)).toBeLessThan(FRAME + 2);
    draw(600);
    expect(sway(600)).toBeLessThanOrEqual(1.001);
    load.pixels = 14;
    draw(1600);
    expect(controller.scale).toBe(1);
  });

  it('keeps to its scales, and says why', () => {
    const controller = budgetOf({ min: 0.5, max: 0.9 });
    expect(controller.scale).toBe(0.9);
    expect(controller.reason).toBe(REASONS.unknown);
    simulate(controller, device({ pixels: 400 }), 'gpu').draw(60);
    expect(controller.scale).toBe(0.5);
    expect(controller.reason).toBe(REASONS.smallest);
    simulate(controller, device({ pixels: 1 }), 'gpu').draw(60);
    expect(controller.scale).toBe(0.9);
    expect(controller.reason).toBe(REASONS.largest);
    expect(budgetOf({ min: 0.7, max: 0.7 }).advance()).toBe(0.7);
  });

  it('does not take a tab that slept, or what is no number, for a slow frame', () => {
    const controller = budgetOf();
    const { draw } = simulate(controller, device({ pixels: 12, delay: 1 }), 'interval');
    draw(30);
    for (const ms of [90_000, NaN, Infinity, -1, 0, 90_000, 90_000]) controller.add(1, ms, 'interval');
    expect(controller.advance()).toBe(1);
    expect(controller.ms).toBeLessThan(FRAME);
  });

  it('begins anew when times come from elsewhere', () => {
    const controller = budgetOf();
    simulate(controller, device({ pixels: 30, delay: 1 }), 'interval').draw(40);
    simulate(controller, device({ pixels: 8 }), 'gpu').draw(60);
    expect(controller.source).toBe('gpu');
    expect(controller.scale).toBe(1);
  });

  it.each([
    [{ frame: NaN }, /frame: NaN.*above 0 ms/],
    [{ frame: 0 }, /above 0 ms/],
    [{ frame: 16.7, min: NaN }, /give a min/],
    [{ frame: 16.7, min: 0.8, max: 0.7 }, /give a min from 0.25 to max/],
    [{ frame: 16.7, max: 1.5 }, /give a max from 0.25 to 1/],
    [{ frame: 16.7, sharpness: 2 }, /give a sharpness from 0 to 1/],
  ])('%o is refused by name', (budget, message) => {
    expect(() => checkBudget(budget)).toThrow(message);
  });
});
