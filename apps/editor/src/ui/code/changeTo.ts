import type { Text } from '@codemirror/state';

/** The smallest single replacement that turns one text into another. */
export function changeTo(before: Text, after: string): { from: number; to: number; insert: string } {
  const old = before.toString();
  let from = 0;
  while (from < old.length && from < after.length && old[from] === after[from]) from++;
  let end = 0;
  while (end < old.length - from && end < after.length - from && old.at(-1 - end) === after.at(-1 - end)) end++;
  return { from, to: old.length - end, insert: after.slice(from, after.length - end) };
}
