/** Whether everything is gone through, as by `npm run agree` and with FAROL_WHOLE=1; `npm test` has what costs most take turns. */
const isWhole = Boolean(process.env.FAROL_AGREE ?? process.env.FAROL_WHOLE);

/**
 * What of a list has its turn: item i at turns i, i + every, i + 2 every, …; all of them with FAROL_AGREE or FAROL_WHOLE.
 *
 * @param turn a whole number
 * @param every turns until each item had one
 */
export const inTurn = <T>(items: readonly T[], turn: number, every: number): T[] =>
  items.filter((_item, index) => isWhole || index % every === turn % every);

/**
 * Splits what one test would go through, so that many browsers can share it: `npm run agree` sets FAROL_AGREE to how many
 * tests there are to be at most. Item i goes to part i modulo their number.
 *
 * @param usual parts without FAROL_AGREE
 * @returns none of them empty
 */
export function parts<T>(items: readonly T[], usual: number): T[][] {
  const count = Math.min(items.length, Number(process.env.FAROL_AGREE) || usual);
  return Array.from({ length: count }, (_, part) => items.filter((_item, index) => index % count === part));
}
