/**
 * Items of a list from one to another, both among them, in the order of the walk from the first to the second: the second
 * comes last, as the primary one of a selection. Null where one of the two is not in the list.
 */
export function rangeOf<Item>(items: readonly Item[], from: Item | null, to: Item): Item[] | null {
  const [first, last] = [items.findIndex((each) => each === from), items.indexOf(to)];
  if (first < 0 || last < 0) return null;
  const range = items.slice(Math.min(first, last), Math.max(first, last) + 1);
  return first < last ? range : range.toReversed();
}
