import { describe, expect, it } from 'vitest';
import { History } from './History';

/** Park and Miller's generator. */
function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647;
  };
}

describe('History', () => {
  it('comes back to every state by undo and redo, over random sequences', () => {
    const next = random(7);
    const history = new History(10_000);
    const values = [0, 0, 0];
    const states = [values.join()];
    let at = 0;
    for (let step = 0; step < 5000; step++) {
      const what = next();
      if (what < 0.5) {
        const index = Math.floor(next() * 3);
        const [before, after] = [values[index], next()];
        values[index] = after;
        history.keep({ label: 'x', undo: () => (values[index] = before), redo: () => (values[index] = after) });
        states.splice(++at, Infinity, values.join());
      } else if (what < 0.8) {
        expect(history.undo()).toBe(at > 0);
        at = Math.max(0, at - 1);
      } else {
        expect(history.redo()).toBe(at < states.length - 1);
        at = Math.min(states.length - 1, at + 1);
      }
      expect(values.join()).toBe(states[at]);
    }
  });

  it('names what it would undo and redo', () => {
    const history = new History();
    expect([history.undoLabel, history.redoLabel]).toEqual([null, null]);
    history.keep({ label: 'move', undo: () => {}, redo: () => {} });
    expect(history.undoLabel).toBe('move');
    history.undo();
    expect([history.undoLabel, history.redoLabel]).toEqual([null, 'move']);
  });

  it('keeps as many edits as it is told', () => {
    const history = new History(2);
    for (const label of ['a', 'b', 'c']) history.keep({ label, undo: () => {}, redo: () => {} });
    expect([history.undo(), history.undo(), history.undo()]).toEqual([true, true, false]);
  });
});
