import { expect, test } from 'vitest';
import { answerOf } from './answerOf';
import { madeUpRun } from './testing/madeUpRun';

test('the answer is who wins most cases, a tie being a win of each; few and many lights are told apart', () => {
  const run = madeUpRun([10, 100, 1000], {
    auto: [0.5, 0.5, 0.5], // excluded, since it draws by one of the others
    forward: [1, 30, 300],
    deferred: [2, 3, 40],
    'tiled-deferred': [2, 3.02, 10],
  });
  expect(answerOf(run)).toEqual({ best: 'tiled-deferred', wins: 2, cases: 3, few: 'forward', many: 'tiled-deferred' });
});

test('a case of one competitor, or without lights of its own to tell, is no answer', () => {
  expect(answerOf(madeUpRun([10], { forward: [1], deferred: ['No WebGL 2.'] }))).toBeNull();
  expect(answerOf(madeUpRun([50], { forward: [1], deferred: [2] }))).toMatchObject({ few: null, many: null });
});
