/** A key of a curve or a stop of a gradient: a time from 0 to 1, and what is there. */
export type TimedKey = readonly [time: number, ...rest: unknown[]];

/** Keys by time, and one of them. */
export interface KeyPlace<K extends TimedKey> {
  readonly keys: readonly K[];
  readonly index: number;
}

/** Keys with one more, after those at its time. */
export function insertKey<K extends TimedKey>(keys: readonly K[], key: K): KeyPlace<K> {
  const after = keys.findIndex(([time]) => time > key[0]);
  const index = after < 0 ? keys.length : after;
  return { keys: keys.toSpliced(index, 0, key), index };
}

/** Keys with another one in the place of one of them; it may pass by others. */
export function moveKey<K extends TimedKey>(keys: readonly K[], index: number, key: K): KeyPlace<K> {
  const [before] = keys[index];
  if (key[0] === before) return { keys: keys.with(index, key), index };
  const others = keys.toSpliced(index, 1);
  if (key[0] < before) return insertKey(others, key);
  // it stays before one at the time that it comes to
  const next = others.findIndex(([time]) => time >= key[0]);
  const place = next < 0 ? others.length : next;
  return { keys: others.toSpliced(place, 0, key), index: place };
}

/** Keys without one of them. */
export const removeKey = <K extends TimedKey>(keys: readonly K[], index: number): readonly K[] =>
  keys.toSpliced(index, 1);

/** A time with the digits that a user can tell apart. */
export const roundTime = (time: number): number => Math.min(Math.max(Math.round(time * 1000) / 1000, 0), 1);
