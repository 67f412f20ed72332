import type { FarolFile, FileObject, Prefab } from '@farol/engine';

/**
 * A scene in parts that are stored one by one, as JSON by key: 'head' (everything but objects and prefabs), 'o/ID' (an
 * object), 'c/ID' (the ids of its children in order; 'c/' for the top), 'p/ID' (a prefab), 'q' (the order of the prefabs).
 */
export type PartKey = string;

/** What a part has become; null when it is gone. */
export type PartChange = readonly [key: PartKey, json: string | null];

export const objectKey = (id: string): PartKey => `o/${id}`;
export const childrenKey = (id: string): PartKey => `c/${id}`;
export const prefabKey = (id: string): PartKey => `p/${id}`;
export const HEAD = 'head';
export const PREFAB_ORDER = 'q';

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
  const prefabs = order.map((id) => read<Prefab>(prefabKey(id)));
  return { ...read<FileHead>(HEAD), ...(prefabs.length > 0 ? { prefabs } : {}), objects };
}
