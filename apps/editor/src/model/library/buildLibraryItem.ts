import { lamps } from './lamps';
import { type LibraryGroup, libraryNames } from './names';
import { type BuiltItem, buildItem, type ItemRoot } from './parts';
import { props } from './props';

const roots: Readonly<Record<LibraryGroup, Readonly<Record<string, () => ItemRoot>>>> = { lamp: lamps, prop: props };

/** Prefab of one of the library's items, in the language that is shown; null for an unknown id. */
export function buildLibraryItem(id: string): BuiltItem | null {
  for (const [group, names] of Object.entries(libraryNames) as [LibraryGroup, Readonly<Record<string, string>>][])
    if (Object.hasOwn(names, id)) return buildItem(id, names[id], roots[group][id]());
  return null;
}
