import type { LightGroup } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import type { LightColumn } from './LightTable';

/** A name in lower case, with numbers padded so that they sort by value. */
export const keyOfName = (name: string): string =>
  name.toLowerCase().replaceAll(/\d+/g, (digits) => digits.padStart(9, '0'));

/** Hue of a linear colour, 0 to 6; -1 for grey. */
export function hueOf([r, g, b]: Vector3Tuple): number {
  const most = Math.max(r, g, b);
  const span = most - Math.min(r, g, b);
  if (span < 1e-6 * most) return -1;
  if (most === r) return ((g - b) / span + 6) % 6;
  return most === g ? (b - r) / span + 2 : (r - g) / span + 4;
}

/** Sort key of a group in a column; 0 when groups have no value there. @param cost - cost of its lights */
export function keyOfGroup(group: LightGroup, column: LightColumn, cost: () => number): number | string {
  if (column === 'name') return keyOfName(group.gameObject.name);
  if (column === 'on') return Number(!group.isActive);
  if (column === 'intensity') return group.dimmer;
  if (column === 'colour') return hueOf(group.colour);
  return column === 'cost' ? -cost() : 0;
}

/** Sorts items by key, reversed when descending; items with equal keys by name. */
export function sortByKey<Item>(
  items: readonly Item[],
  keyOf: (item: Item) => number | string,
  nameKeyOf: (item: Item) => string,
  isDescending: boolean,
): Item[] {
  const keys = new Map(items.map((item) => [item, keyOf(item)]));
  const sign = isDescending ? -1 : 1;
  return items.toSorted((a, b) => {
    const [first, second] = [keys.get(a)!, keys.get(b)!];
    if (first !== second) return first < second ? -sign : sign;
    const [nameA, nameB] = [nameKeyOf(a), nameKeyOf(b)];
    return nameA < nameB ? -1 : nameA > nameB ? 1 : 0;
  });
}
