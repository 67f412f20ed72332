import { describe, expect, it } from 'vitest';
import { type SceneFigures, TechniqueChooser } from '../warm-up/TechniqueChooser';
import { LearntChoices } from './LearntChoices';
import { readVerdict, TechniqueLearner } from './TechniqueLearner';

const figures: SceneFigures = {
  bounded: 40,
  everywhere: 0,
  coverage: 3.5,
  objects: 100,
  transparents: false,
  floatTargets: true,
  surfaces: false,
  ...{ pixels: 1920 * 1080, multisampled: false, overdraw: 0, triangles: 0 },
};
const rule = new TechniqueChooser();

/** Numbers 0 to 1 (mulberry32). */
function random(seed: number): () => number {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A storage with the initial content `text`. */
function storageOf(text: string | null = null) {
  return {
    text,
    getItem() {
      return this.text;
    },
    setItem(_: string, value: string) {
      this.text = value;
    },
    removeItem() {
      this.text = null;
    },
  };
}

/** Draws frames on a simulated GPU, on which the rule's technique takes 8 ms and its rival `rivalTime`, with 10% of noise. */
function simulate(storage = storageOf(), seed = 7) {
  const learner = new TechniqueLearner(new LearntChoices('GPU', storage));
  const noise = random(seed);
  const technique = rule.best(figures, 1);
  const rival = learner.rivalOf(technique, rule, figures, false)!;
  const key = learner.keyOf(technique, rival, figures);
  const state = { rivalTime: 8, trials: 0, changes: 0 };
  const time = (ms: number) => ms * (0.9 + 0.2 * noise());
  const draw = (frames: number) => {
    for (let i = 0; i < frames; i++) {
      const faster = learner.fasterOf(technique, rival, key);
      if (!learner.isDue(key)) continue;
      learner.begin();
      state.trials++;
      learner.add(key, technique, time(8), rival, time(state.rivalTime));
      if (learner.fasterOf(technique, rival, key) !== faster) state.changes++;
    }
    return learner.fasterOf(technique, rival, key);
  };
  return { learner, technique, rival, key, state, draw };
}

describe('TechniqueLearner', () => {
  it('unlearns a rule that is wrong on this GPU, and what it learnt when that is wrong, by fifteen trials each', () => {
    const { draw, state, technique, rival } = simulate();
    expect([technique, rival]).toEqual(['clustered-deferred', 'clustered-forward']);
    state.rivalTime = 5;
    expect(draw(64 * 15 - 1)).toBe(technique);
    expect(draw(1)).toBe(rival);
    expect(draw(5000)).toBe(rival);
    state.rivalTime = 12;
    expect(draw(512 * 30)).toBe(technique);
    expect(state.changes).toBe(2);
  });

  it('keeps to the rule where it is right, and where both take the same', () => {
    for (const ratio of [1.5, 1])
      for (let seed = 0; seed < 50; seed++) {
        const { draw, state, technique } = simulate(storageOf(), seed);
        state.rivalTime = 8 * ratio;
        expect(draw(64 * 15), `${ratio}, ${seed}`).toBe(technique);
      }
  });

  it('does not go to and fro between techniques that take about the same', () => {
    const { draw, state, rival } = simulate();
    state.rivalTime = 5;
    expect(draw(64 * 15)).toBe(rival);
    state.rivalTime = 8;
    expect(draw(40_000)).toBe(rival);
    expect(state.changes).toBe(1);
  });

  it('tries at most 2% of the draws, and 0.2% once it has learnt', () => {
    const { draw, state } = simulate();
    draw(64 * 15);
    expect(state.trials / (64 * 15)).toBeLessThan(0.02);
    const before = state.trials;
    draw(51_200);
    expect((state.trials - before) / 51_200).toBeLessThan(0.002);
  });

  it('learns nothing from times that are none', () => {
    const { draw, state, learner, technique } = simulate();
    for (const time of [0, NaN, Infinity]) {
      state.rivalTime = time;
      expect(draw(64 * 20)).toBe(technique);
    }
    expect(learner.learnt.size).toBe(0);
  });

  it('keeps what it learnt apart by the numbers of lights, lights a pixel and pixels, whichever technique the rule picks', () => {
    const { learner, key, technique, rival } = simulate();
    const { pixels } = figures;
    const keyOf = (other: Partial<SceneFigures>, by = rival) => learner.keyOf(technique, by, { ...figures, ...other });
    expect(keyOf({ bounded: 45, coverage: 3, pixels: pixels + 5, overdraw: 15 })).toBe(key);
    const others = [keyOf({ bounded: 130 }), keyOf({ coverage: 20 }), keyOf({ pixels: pixels / 4 })];
    expect(new Set([key, ...others]).size).toBe(4);
    const depthFirst = [0.2, 1, 15].map((overdraw) => keyOf({ overdraw }, 'forward-plus'));
    expect(new Set([key, ...depthFirst]).size, 'of a technique that draws depth first by overdraw too').toBe(4);
    expect(learner.keyOf(rival, technique, figures)).toBe(key);
    learner.learnt.set(key, 0); // clustered-forward
    expect(learner.fasterOf(technique, rival, key)).toBe(rival);
    expect(learner.fasterOf(rival, technique, key)).toBe(rival);
  });

  it('hesitates to draw depth first where that is about as good', () => {
    const { learner } = simulate();
    const rivalOf = (overdraw: number, multisampled = false) => {
      const layered = { ...figures, bounded: 60, coverage: 8, overdraw, multisampled };
      return learner.rivalOf(rule.best(layered, 1), rule, layered, multisampled);
    };
    expect(rivalOf(0.45)).toBe('forward-plus');
    expect(rivalOf(0.55)).toBe('clustered-deferred');
    expect(rivalOf(0.45, true)).not.toBe('forward-plus');
  });

  it('hesitates only near the bounds of the rule, and never between edges that look different', () => {
    const { learner } = simulate();
    const rivalOf = (other: Partial<SceneFigures>, multisampled = false) => {
      const scene = { ...figures, ...other };
      return learner.rivalOf(rule.best(scene, 1), rule, scene, multisampled);
    };
    expect(rivalOf({})).toBe('clustered-forward');
    expect(rivalOf({}, true)).toBe('tiled-deferred');
    expect(rivalOf({ coverage: 100, bounded: 5000, objects: 5000 })).toBe(null);
    expect(rivalOf({ surfaces: true, bounded: 10 })).toBe(null);
  });
});

describe('LearntChoices', () => {
  it('keeps verdicts from visit to visit, by GPU, until they are cleared', () => {
    const storage = storageOf();
    const { draw, state, rival, key } = simulate(storage);
    state.rivalTime = 5;
    draw(64 * 15);
    const later = simulate(storage);
    expect(later.draw(1)).toBe(rival);
    expect(new LearntChoices('another GPU', storage).get(key)).toBeUndefined();
    later.learner.clear();
    expect(later.draw(1)).toBe(later.technique);
    expect(new LearntChoices('GPU', storage).size).toBe(0);
  });

  it('ignores what another version or somebody else has stored', () => {
    const stored = (version: number, list: unknown) => JSON.stringify({ version, gpus: { GPU: list } });
    const texts = [
      '{',
      '3',
      '[]',
      '{"version":2}',
      stored(1, [[5, 1]]),
      stored(2, [[5, 3]]),
      stored(2, [['x', 1]]),
      stored(2, 7),
    ];
    for (const text of texts) {
      const learnt = new LearntChoices('GPU', storageOf(text));
      expect(learnt.size, text).toBe(0);
      learnt.set(5, 1);
      expect(learnt.get(5)).toBe(1);
    }
    expect(new LearntChoices('GPU', storageOf(stored(2, [[5, 1]]))).get(5)).toBe(1);
  });

  it('is bounded, by entries and by GPUs', () => {
    const storage = storageOf();
    for (let gpu = 0; gpu < 9; gpu++) {
      const learnt = new LearntChoices(`GPU ${gpu}`, storage);
      for (let key = 0; key < (gpu === 8 ? 400 : 3); key++) learnt.set(key, 0);
    }
    const last = new LearntChoices('GPU 8', storage);
    expect([last.size, last.get(399), last.get(0)]).toEqual([256, 0, undefined]);
    expect([0, 4, 5, 6, 7].map((gpu) => new LearntChoices(`GPU ${gpu}`, storage).size)).toEqual([0, 0, 3, 3, 3]);
  });

  it('goes on within the page where the storage is full or forbidden', () => {
    const refuse = () => {
      throw new Error('forbidden');
    };
    const learnt = new LearntChoices('GPU', { getItem: refuse, setItem: refuse, removeItem: refuse });
    learnt.set(5, 1);
    expect(learnt.get(5)).toBe(1);
    learnt.clear();
    expect(learnt.size).toBe(0);
  });
});

it('tells a stored verdict in words: the pair, the faster one, and where it holds', () => {
  const storage = storageOf();
  const choices = new LearntChoices('GPU', storage);
  const learner = new TechniqueLearner(choices);
  const key = learner.keyOf('tiled-deferred', 'clustered-forward', figures);
  for (let i = 0; i < 15; i++) learner.add(key, 'clustered-forward', 2, 'tiled-deferred', 1);
  const told = {
    ...{ gpu: 'GPU', techniques: ['clustered-forward', 'tiled-deferred'], faster: 'tiled-deferred' },
    ...{ lights: 32, coverage: 2, overdraw: 1, pixels: 2 ** 20 },
  };
  expect(choices.all().map((each) => readVerdict(...each))).toEqual([told]);
  // verdicts of other GPUs are stored too
  expect(new LearntChoices('other', storage).all().map((each) => readVerdict(...each))).toEqual([told]);
  expect(readVerdict('GPU', key, 2).faster).toBeNull();
});
