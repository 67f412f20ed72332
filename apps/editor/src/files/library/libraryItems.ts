import { t } from '@farol/editing';
import { libraryMaterials } from '../../model/library/materials';
import { type LibraryGroup, type LibraryId, libraryNames } from '../../model/library/names';
import { libraryTags } from '../../model/library/tags';

/** An item of the library, as its panel shows it. */
export interface LibraryItem {
  /** Id, such as 'street-lamp' or 'material/Cast iron'; ids of the user's prefabs begin with 'own/' or 'folder/'. */
  readonly id: string;
  /** Name in the user's language. */
  readonly label: string;
  readonly group: LibraryGroup | 'material' | 'own' | 'folder';
  /** Words by which the item is searched and filtered, in the user's language. */
  readonly tags: readonly string[];
  /** URL of the item's picture; null for none. */
  readonly picture: string | null;
}

/** Ids of items that draw nothing. */
const unseen: ReadonlySet<string> = new Set(['player', 'zone']);

/** File in `public/library` with an item's picture; null for an item that draws nothing. */
export const pictureFile = (id: string): string | null =>
  unseen.has(id) ? null : `${id.replaceAll(/[ /]/g, '-').toLowerCase()}.webp`;

function pictureOf(id: string): string | null {
  const file = pictureFile(id);
  return file && new URL(`library/${file}`, document.baseURI).href;
}

/** The items that come with the editor. */
export const libraryItems = (): LibraryItem[] => [
  ...(Object.keys(libraryNames) as LibraryGroup[]).flatMap((group) =>
    Object.entries<string>(libraryNames[group]).map(([id, name]) => ({
      ...{ id, label: t(name), group },
      tags: libraryTags[id as LibraryId].map((tag) => t(tag)),
      picture: pictureOf(id),
    })),
  ),
  ...Object.keys(libraryMaterials).map((name) => {
    const id = `material/${name}`;
    return { id, label: t(name), group: 'material' as const, tags: [t('Material')], picture: pictureOf(id) };
  }),
];
