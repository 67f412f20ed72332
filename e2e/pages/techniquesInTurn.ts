import { type TechniqueName, techniques } from '@farol/renderer';

const all = Object.keys(techniques) as TechniqueName[];

/** All techniques but 'auto', which is one of the others. */
export const drawn = all.filter((name) => name !== 'auto');

/** Techniques whose materials go through the lights, and those that light a G-buffer or fill a buffer of light; without 'auto'. */
export const families = [
  drawn.filter((name) => name.includes('forward')),
  drawn.filter((name) => !name.includes('forward')),
];

/** Extent of the tests (packages/tools/extent.mjs), as the page's address has it; all of it where that says nothing. */
export const isSlice = new URLSearchParams(location.search).get('tests') === 'slice';

/**
 * Picks the techniques that a test goes through: all of them, but in the slice one of each family. Tests differ in their
 * turn, so that each technique is drawn by several.
 *
 * @param turn - a whole number from 0
 * @param known - what is picked from, default all
 */
export function techniquesInTurn(turn: number): TechniqueName[];
export function techniquesInTurn<T extends TechniqueName>(turn: number, known: readonly T[]): T[];
export function techniquesInTurn(turn: number, known: readonly TechniqueName[] = all): TechniqueName[] {
  if (!isSlice) return [...known];
  return families.flatMap((family) => {
    const own = family.filter((name) => known.includes(name));
    return own.length > 0 ? [own[turn % own.length]] : [];
  });
}

/**
 * Picks the techniques that one case of a list is drawn by: all, but in the slice a single one of those that are known, case
 * by case another.
 *
 * @param turn - number of the case
 */
export const techniqueInTurn = <T extends TechniqueName>(turn: number, known: readonly T[]): readonly T[] =>
  isSlice ? [known[turn % known.length]] : known;
