import { describe, expect, it } from 'vitest';
import { FogHistory } from './FogHistory';
import { fogWork, turnsOf } from './fogWork';
import { checkFroxels, fogQualities, type Froxels } from './froxels';

const count = ([across, up, away]: Froxels): number => across * up * away;

describe('the work of fog', () => {
  it('is as ever on strong devices, however many lights there are', () => {
    const { froxels, sums, stillFrames, forgets } = fogWork(false, false);
    expect([froxels, stillFrames, forgets]).toEqual([fogQualities.medium, 64, 0]);
    expect(turnsOf(froxels, 100_000, sums, 8)).toBe(1);
  });

  it('is less with the quality lite, and least on a software rasteriser', () => {
    const [full, lite, software] = [fogWork(false, false), fogWork(true, false), fogWork(false, true)];
    expect(fogWork(true, true)).toBe(software);
    expect(count(full.froxels)).toBeGreaterThan(5 * count(lite.froxels));
    expect(count(full.froxels)).toBeGreaterThan(12 * count(software.froxels));
    expect(software.stillFrames).toBeLessThanOrEqual(8);
  });

  it.each([1, 19, 40, 80, 150])('of a frame on a software rasteriser is bounded, with %i lights', (lights) => {
    const { froxels, sums } = fogWork(false, true);
    const turns = turnsOf(froxels, lights, sums, 8);
    expect((count(froxels) * lights) / turns).toBeLessThanOrEqual(sums);
    expect([1, 2, 4, 8]).toContain(turns);
    expect(turnsOf(froxels, 1e6, sums, 8)).toBe(8);
    expect(turnsOf(froxels, 1e6, sums, 4)).toBe(4);
  });
});

describe('the mean of frames', () => {
  const shares = (
    frames: number,
    changed: (frame: number) => boolean,
    isStill: boolean,
    turns: number,
    forgets = 0,
  ) => {
    const history = new FogHistory();
    return Array.from({ length: frames }, (_, frame) => {
      history.note(12, changed(frame), isStill, turns, forgets);
      return [history.share, history.otherShare];
    });
  };
  const never = (): boolean => false;

  it('without turns is that of all frames, of 64 at rest and of 12 in motion', () => {
    expect(shares(80, never, true, 1).map(([share]) => Math.round(1 / share))).toEqual(
      Array.from({ length: 80 }, (_, i) => Math.min(64, i + 1)),
    );
    expect(1 / shares(80, never, false, 1).at(-1)![0]).toBe(12);
  });

  it('with turns begins with the slices that are lit, and gives each slice its own in the first round', () => {
    expect(shares(12, never, true, 4)).toEqual([
      [1, 1],
      ...Array.from({ length: 3 }, () => [1, 0]),
      ...Array.from({ length: 4 }, () => [1 / 2, 0]),
      ...Array.from({ length: 4 }, () => [1 / 3, 0]),
    ]);
    // in motion, at least two rounds of slices are averaged
    expect(1 / shares(80, never, false, 8).at(-1)![0]).toBe(2);
  });

  it('keeps little of the light before a change, after the frames of a still scene', () => {
    const { forgets, stillFrames } = fogWork(false, true);
    const left = shares(24 + stillFrames, (frame) => frame === 24, true, 1, forgets)
      .slice(24)
      .reduce((rest, [share]) => rest * (1 - share), 1);
    expect(left).toBeLessThan(0.05);
    // slices not computed in the frame follow changes too
    const [share, otherShare] = shares(40, (frame) => frame > 20, true, 8).at(-1)!;
    expect([share, otherShare]).toEqual([1 / 3, 1 / 3]);
  });
});

it.each<[Froxels, RegExp]>([
  [[160, 90, 60], /froxels is \[160, 90, 60\].*multiple of 8/],
  [[0, 90, 64], /whole numbers above 0/],
  [[1.5, 90, 64], /whole numbers above 0/],
  [[160, 90] as unknown as Froxels, /three whole numbers/],
])('froxels %o are refused', (froxels, message) => {
  expect(() => checkFroxels(froxels)).toThrow(message);
  expect(checkFroxels([40, 10, 16])).toEqual([40, 10, 16]);
});
