import { t } from '@farol/editing';
import { type LibraryGroup, type LibraryId, libraryNames } from '../../model/library/names';
import { libraryTags } from '../../model/library/tags';

/** An item of the library, as its panel shows it. */
export interface LibraryItem {
  readonly id: string;
  /** Name in the language that is shown. */
  readonly label: string;
  readonly group: LibraryGroup;
  /** Words in the language that is shown. */
  readonly tags: readonly string[];
  /** Address of its picture. */
  readonly picture: string;
}

/** The items that come with the editor. */
export const libraryItems = (): LibraryItem[] =>
  (Object.keys(libraryNames) as LibraryGroup[]).flatMap((group) =>
    Object.entries<string>(libraryNames[group]).map(([id, name]) => ({
      ...{ id, label: t(name), group },
      tags: libraryTags[id as LibraryId].map((tag) => t(tag)),
      picture: new URL(`library/${id}.webp`, document.baseURI).href,
    })),
  );
