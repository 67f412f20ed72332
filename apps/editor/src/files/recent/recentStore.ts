import type { RecentFile } from '../../model/RecentFiles';

const NAME = 'farol-recent';

const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(request.error ?? new Error('The browser refused to store.')));
  });

/** Opens the store, performs one operation, and closes it. */
async function use<T>(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const request = indexedDB.open(NAME, 1);
  request.addEventListener('upgradeneeded', () => request.result.createObjectStore('files', { keyPath: 'id' }));
  const database = await done(request);
  try {
    return await done(act(database.transaction('files', mode).objectStore('files')));
  } finally {
    database.close();
  }
}

/** All recent files, newest first. */
export async function readRecent(): Promise<RecentFile[]> {
  const files = (await use('readonly', (store) => store.getAll())) as RecentFile[];
  return files.toSorted((a, b) => b.time - a.time);
}

export const writeRecent = (file: RecentFile): Promise<unknown> => use('readwrite', (store) => store.put(file));

export const deleteRecent = (id: string): Promise<unknown> => use('readwrite', (store) => store.delete(id));
