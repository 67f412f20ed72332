import { lamps } from './lamps';
import { libraryNames, type PrefabGroup } from './names';
import { type BuiltItem, buildItem, type ItemRoot } from './parts';
import { play } from './play';
import { props } from './props';

const roots: Readonly<Record<PrefabGroup, Readonly<Record<string, () => ItemRoot>>>> = {
  ...{ lamp: lamps, prop: props, play },
};

/** Prefab of one of the library's items, in the user's language; null for an unknown id. */
export function buildLibraryItem(id: string): BuiltItem | null {
  for (const group of Object.keys(roots) as PrefabGroup[]) {
    const names: Readonly<Record<string, string>> = libraryNames[group];
    if (Object.hasOwn(names, id)) return buildItem(id, names[id], roots[group][id]());
  }
  return null;
}
