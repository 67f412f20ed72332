import { expect, it, vi } from 'vitest';
import { chanceExceptions } from '../render/chanceExceptions';
import { decksOf, scenesByKind } from './chance';

vi.mock('@playwright/test', () => ({ test: {} }));

it('puts seeds into the decks that they share their programs in', () => {
  expect(decksOf(6, 4, 8)).toEqual([
    [6, 7],
    [8, 9],
  ]);
});

it('tells faults by kind, the most frequent first, each by its smallest scene', () => {
  const fault = { techniques: ['deferred'], fault: '40 dB', isLeftOver: false };
  const notes = [
    { ...fault, seed: 1, kind: 'fog', facts: { world: { fog: {} } } },
    { ...fault, seed: 2, kind: 'points', facts: { things: [{ as: 'points' }, {}] } },
    { ...fault, seed: 3, kind: 'points', facts: { things: [{ as: 'points' }] } },
    { seed: 4, why: 'one colour' },
  ];
  expect(scenesByKind(notes.map((note) => JSON.stringify(note)))).toEqual([
    '\n2 × points: seeds 2 3',
    '  deferred: 40 dB',
    '  {"things":[{"as":"points"}]}',
    '\n1 × fog: seeds 1',
    '  deferred: 40 dB',
    '  {"world":{"fog":{}}}',
    '\nnot compared, one colour: seeds 4',
  ]);
});

/** Scenes that were off when the table was made; mend one, and lower this. */
const MOST = 0;

it('has no more exceptions than it began with', () => {
  const seeds = chanceExceptions.flatMap((one) => one.seeds);
  expect(new Set(seeds).size).toBe(seeds.length);
  expect(seeds.length).toBeLessThanOrEqual(MOST);
});
