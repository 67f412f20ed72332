/**
 * The techniques that one of many pictures is drawn by: some of them, in turn, so that over all pictures each has its share
 * and the whole takes minutes. With FAROL_SWEEP=all every picture is drawn by every technique.
 *
 * @param turn which of the pictures it is, from 0
 * @param count techniques a picture
 */
export function techniquesInTurn<Name extends string>(names: readonly Name[], turn: number, count: number): Name[] {
  if (process.env.FAROL_SWEEP === 'all') return [...names];
  return Array.from({ length: Math.min(count, names.length) }, (_, i) => names[(turn * count + i) % names.length]);
}
