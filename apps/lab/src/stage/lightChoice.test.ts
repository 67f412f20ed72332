import { describe, expect, it } from 'vitest';
import { evenly, lightParameters } from './lightChoice';

describe('the number of lights', () => {
  it('is told to a scene as it takes it', () => {
    expect(lightParameters(['lights', 'seed'], 30)).toEqual({ lights: 30 });
    expect(lightParameters(['n', 'm', 'seed'], 9)).toEqual({ m: 3 });
    expect(lightParameters(['n', 'm', 'seed'], 10)).toEqual({ m: 4 });
    expect(lightParameters(['seed'], 10)).toEqual({});
  });

  it('is exact where a square has more, by lights from all over it', () => {
    expect(evenly(16, 16)).toHaveLength(16);
    const chosen = evenly(10, 16);
    expect(new Set(chosen).size).toBe(10);
    expect(chosen.at(-1)).toBeGreaterThan(12);
    expect(evenly(0, 0)).toEqual([]);
  });
});
