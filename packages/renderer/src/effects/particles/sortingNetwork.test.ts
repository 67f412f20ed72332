import { expect, test } from 'vitest';
import { sortingNetwork } from './sortingNetwork';

/** A pass like particleSort.glsl's, in JavaScript. */
function pass(keys: readonly number[], partners: readonly number[]): number[] {
  let now = [...keys];
  for (const partner of partners) {
    if (partner === 0) continue;
    now = now.map((key, i) => (i < (i ^ partner) ? Math.max(key, now[i ^ partner]) : Math.min(key, now[i ^ partner])));
  }
  return now;
}

const inversions = (keys: readonly number[]) =>
  keys.reduce((sum, key, i) => sum + keys.slice(i + 1).filter((later) => later > key).length, 0);
const shuffled = (count: number) => Array.from({ length: count }, (_, i) => (i * 7919 + 13) % count);

test.each([1, 2, 3, 5, 7])('it sorts 2 to the power of %i keys, farthest first', (bits) => {
  const keys = shuffled(2 ** bits);
  const sorted = sortingNetwork(bits).reduce(pass, keys);
  expect(sorted).toEqual(keys.toSorted((a, b) => b - a));
});

test('no part of it makes an order worse, and what is sorted stays so', () => {
  let keys: number[] = shuffled(128);
  for (const partners of sortingNetwork(7)) {
    const next = pass(keys, partners);
    expect(inversions(next)).toBeLessThanOrEqual(inversions(keys));
    keys = next;
  }
  for (const partners of sortingNetwork(7)) expect(pass(keys, partners)).toEqual(keys);
});

test('three steps are a pass: 1024 keys take 22', () => {
  expect([10, 15, 17].map((bits) => sortingNetwork(bits).length)).toEqual([22, 45, 57]);
});
