import { compareSpreads } from './compareSpreads';
import type { Spread } from '../results/LabRun';

/** Times of two competitors at the same value. */
export interface Pair {
  readonly value: number;
  readonly a: Spread;
  readonly b: Spread;
}

/**
 * From which value on `a` takes longer than `b`.
 *
 * - `never`: `a` is never surely slower; `ahead` tells whether it is surely faster anywhere
 * - `always`: `a` is surely slower somewhere and nowhere surely faster
 * - `from`: `a` is faster up to `before` and slower from `after` on; `at` lies between, interpolated on log axes
 * - `mixed`: they change places more than once, or `a` falls behind first and gets ahead later
 */
export type Crossing =
  | { kind: 'none' }
  | { kind: 'never'; ahead: boolean }
  | { kind: 'always'; first: number }
  | { kind: 'from'; before: number; after: number; at: number }
  | { kind: 'mixed'; ahead: number[]; behind: number[] };

/** Finds where two curves cross; pairs in ascending order of their value, ties left out of account. */
export function findCrossing(pairs: readonly Pair[]): Crossing {
  if (pairs.length === 0) return { kind: 'none' };
  const sure = pairs
    .map((pair) => ({ pair, order: compareSpreads(pair.a, pair.b) }))
    .filter(({ order }) => order !== 0);
  const behind = sure.filter(({ order }) => order === 1);
  const ahead = sure.filter(({ order }) => order === -1);
  if (behind.length === 0) return { kind: 'never', ahead: ahead.length > 0 };
  if (ahead.length === 0) return { kind: 'always', first: behind[0].pair.value };
  const last = ahead.at(-1)!.pair;
  const next = behind[0].pair;
  if (sure.indexOf(ahead.at(-1)!) > sure.indexOf(behind[0])) {
    return {
      kind: 'mixed',
      ahead: ahead.map(({ pair }) => pair.value),
      behind: behind.map(({ pair }) => pair.value),
    };
  }
  return { kind: 'from', before: last.value, after: next.value, at: interpolate(last, next) };
}

/** Where log(a / b) passes 0 between two pairs, over the logarithm of their values; over the values where one is 0. */
function interpolate(from: Pair, to: Pair): number {
  const ratio = ({ a, b }: Pair): number => Math.log(a.median / b.median);
  const share = ratio(from) / (ratio(from) - ratio(to));
  if (from.value <= 0) return from.value + share * (to.value - from.value);
  return Math.exp(Math.log(from.value) + share * (Math.log(to.value) - Math.log(from.value)));
}
