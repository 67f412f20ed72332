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
