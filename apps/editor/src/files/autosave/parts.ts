import type { FarolFile, FileObject } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';

/**
 * A scene in parts that are stored one by one, as JSON by key: 'head' (everything but objects and prefabs), 'o/ID' (an
 * object), 'c/ID' (the ids of its children in order; 'c/' for the top), 'p/ID' (a prefab, with the number of its pieces),
 * 'r/ID/N' (a piece: some of its objects), 'q' (the order of the prefabs).
 */
export type PartKey = string;

/** What a part has become; null when it is gone. */
export type PartChange = readonly [key: PartKey, json: string | null];

export const objectKey = (id: string): PartKey => `o/${id}`;
export const childrenKey = (id: string): PartKey => `c/${id}`;
export const prefabKey = (id: string): PartKey => `p/${id}`;
export const pieceKey = (id: string, index: number): PartKey => `r/${id}/${index}`;
export const HEAD = 'head';
export const PREFAB_ORDER = 'q';

/** Parts as they were, and what became of some since. */
export function mergeParts(base: readonly PartChange[], changes: Iterable<PartChange>): Map<PartKey, string> {
  const parts = new Map<PartKey, string>();
  for (const list of [base, changes]) {
    for (const [key, json] of list) {
      if (json === null) parts.delete(key);
      else parts.set(key, json);
    }
  }
  return parts;
}

/** A prefab without its objects, which are in pieces: a large one would hold up the page as a whole. */
export interface PrefabPart {
  readonly id: string;
  readonly name: string;
  readonly pieces: number;
}

/** Everything of a file but objects and prefabs. */
export type FileHead = Omit<FarolFile, 'objects' | 'prefabs'>;

/**
 * Puts a file together of its parts.
 * @throws Error when parts are missing: the store was damaged
 */
export function assembleParts(parts: ReadonlyMap<PartKey, string>): FarolFile {
  const read = <T>(key: PartKey): T => {
    const json = parts.get(key);
    if (json === undefined) throw new Error(`The part '${key}' of the autosave is missing.`);
    return JSON.parse(json) as T;
  };
  const objects: FileObject[] = [];
  const visit = (container: string): void => {
    const json = parts.get(childrenKey(container));
    for (const id of json === undefined ? [] : (JSON.parse(json) as string[])) {
      objects.push(read<FileObject>(objectKey(id)));
      visit(id);
    }
  };
  visit('');
  const order = parts.has(PREFAB_ORDER) ? read<string[]>(PREFAB_ORDER) : [];
  const prefabs = order.map((key): Prefab => {
    const part = read<PrefabPart | Prefab>(prefabKey(key));
    // as versions before this one stored it
    if ('objects' in part) return part;
    const { id, name, pieces } = part;
    const objects = Array.from({ length: pieces }, (_, i) => read<FileObject[]>(pieceKey(id, i))).flat();
    return { id, name, objects };
  });
  return { ...read<FileHead>(HEAD), ...(prefabs.length > 0 ? { prefabs } : {}), objects };
}
