import { expect, it } from 'vitest';
import { CommandStack } from './CommandStack';
import type { Command } from './Command';

/** Park and Miller's generator: numbers from 0 to 1. */
function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647;
  };
}

/** Command that sets a number of a list. */
function setNumber(values: number[], index: number, value: number): Command {
  const before = values[index];
  return {
    label: `Set ${index}`,
    do: () => void (values[index] = value),
    undo: () => void (values[index] = before),
  };
}

it('comes back to every state by undo and redo, over random steps and gestures', () => {
  const next = random(7);
  const stack = new CommandStack(undefined, 10_000);
  const values = [0, 0, 0];
  const states = [values.join()];
  let at = 0;
  for (let step = 0; step < 5000; step++) {
    const what = next();
    const index = Math.floor(next() * 3);
    if (what < 0.3) {
      stack.run(setNumber(values, index, next()));
      states.splice(++at, Infinity, values.join());
    } else if (what < 0.5) {
      const gesture = stack.begin();
      const before = [...values];
      for (let i = 0; i < 3; i++) {
        gesture.reset();
        gesture.preview(setNumber(values, (index + i) % 3, next()));
      }
      if (next() < 0.3) {
        gesture.discard();
        expect(values).toEqual(before);
      } else {
        gesture.commit();
        states.splice(++at, Infinity, values.join());
      }
    } else if (what < 0.8) {
      expect(stack.undo()).toBe(at > 0);
      at = Math.max(0, at - 1);
    } else {
      expect(stack.redo()).toBe(at < states.length - 1);
      at = Math.min(states.length - 1, at + 1);
    }
    expect(values.join()).toBe(states[at]);
  }
  expect(states.length).toBeGreaterThan(50);
});
