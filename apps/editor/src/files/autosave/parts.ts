import type { FarolFile, FileObject } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';

/**
 * Key of a part of a scene stored as JSON: 'head' (everything but objects and prefabs), 'o/ID' (an object), 'c/ID' (ids
 * of its children in order; 'c/' for the top), 'p/ID' (a prefab, with the number of its pieces), 'r/ID/N' (piece N:
 * some of its objects), 'q' (the order of the prefabs).
 */
export type PartKey = string;

/** New JSON of a part; null when the part was removed. */
export type PartChange = readonly [key: PartKey, json: string | null];

export const objectKey = (id: string): PartKey => `o/${id}`;
export const childrenKey = (id: string): PartKey => `c/${id}`;
export const prefabKey = (id: string): PartKey => `p/${id}`;
export const pieceKey = (id: string, index: number): PartKey => `r/${id}/${index}`;
export const HEAD = 'head';
export const PREFAB_ORDER = 'q';

/** Applies changes to a map of parts. */
export function changeParts(parts: Map<PartKey, string>, changes: Iterable<PartChange>): void {
  for (const [key, json] of changes) {
    if (json === null) parts.delete(key);
    else parts.set(key, json);
  }
}

export function mergeParts(base: readonly PartChange[], changes: Iterable<PartChange>): Map<PartKey, string> {
  const parts = new Map<PartKey, string>();
  changeParts(parts, base);
  changeParts(parts, changes);
  return parts;
}

/** A prefab without its objects, which are stored in pieces, since a large one would block the page. */
export interface PrefabPart {
  readonly id: string;
  readonly name: string;
  readonly pieces: number;
}

/** Everything in a scene file but objects and prefabs. */
export type FileHead = Omit<FarolFile, 'objects' | 'prefabs'>;

/**
 * Assembles a scene file from its parts.
 * @throws Error when parts are missing, since the store was damaged
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
    // parts stored by earlier versions of the editor hold whole objects
    if ('objects' in part) return part;
    const { id, name, pieces } = part;
    const objects = Array.from({ length: pieces }, (_, i) => read<FileObject[]>(pieceKey(id, i))).flat();
    return { id, name, objects };
  });
  return { ...read<FileHead>(HEAD), ...(prefabs.length > 0 ? { prefabs } : {}), objects };
}
