/** A key of a curve or a stop of a gradient: time from 0 to 1, then values. */
export type TimedKey = readonly [time: number, ...rest: unknown[]];

/** Sorted keys, and the index of one of them. */
export interface KeyPlace<K extends TimedKey> {
  readonly keys: readonly K[];
  readonly index: number;
}

/** Inserts a key into a sorted list, after other keys of the same time. */
export function insertKey<K extends TimedKey>(keys: readonly K[], key: K): KeyPlace<K> {
  const after = keys.findIndex(([time]) => time > key[0]);
  const index = after < 0 ? keys.length : after;
  return { keys: keys.toSpliced(index, 0, key), index };
}

/** Replaces a key, keeping the order by time. */
export function moveKey<K extends TimedKey>(keys: readonly K[], index: number, key: K): KeyPlace<K> {
  const [before] = keys[index];
  if (key[0] === before) return { keys: keys.with(index, key), index };
  const others = keys.toSpliced(index, 1);
  if (key[0] < before) return insertKey(others, key);
  // a key that moves later goes before others at its new time
  const next = others.findIndex(([time]) => time >= key[0]);
  const place = next < 0 ? others.length : next;
  return { keys: others.toSpliced(place, 0, key), index: place };
}

export const removeKey = <K extends TimedKey>(keys: readonly K[], index: number): readonly K[] =>
  keys.toSpliced(index, 1);

/** Rounds a time to 0.001, and clamps it to 0 to 1. */
export const roundTime = (time: number): number => Math.min(Math.max(Math.round(time * 1000) / 1000, 0), 1);
