import { availableParallelism } from 'node:os';
import { isWhole } from '@farol/tools/extent';

/**
 * Picks what of a list has its turn in the slice: item i at turns i, i + every, i + 2 every, …; all of them in more than the
 * slice.
 *
 * @param turn - a whole number
 * @param every - turns until each item had one
 */
export const inTurn = <T>(items: readonly T[], turn: number, every: number): T[] =>
  items.filter((_item, index) => isWhole || index % every === turn % every);

/**
 * Splits what one test would go through, so that many browsers can share it: in more than the slice into as many tests as the
 * machine has cores. Item i goes to part i modulo their number.
 *
 * @param usual - parts in the slice
 * @returns none of them empty
 */
export function parts<T>(items: readonly T[], usual: number): T[][] {
  const count = Math.min(items.length, isWhole ? Math.max(usual, availableParallelism()) : usual);
  return Array.from({ length: count }, (_, part) => items.filter((_item, index) => index % count === part));
}
