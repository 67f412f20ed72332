/** Error of a request or transaction of IndexedDB. */
export const refused = (error: DOMException | null | undefined): Error =>
  error ?? new Error('The browser refused to store data.');

/** Result of a request of IndexedDB. */
export const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(refused(request.error)));
    request.addEventListener('blocked', () => reject(new Error('Another tab blocks the storage: close that tab.')));
  });

/** Records of a database in the browser, each with an `id`. All functions reject when the browser has no storage. */
export interface KeyedStore<T extends { readonly id: string }> {
  all(): Promise<T[]>;
  put(record: T): Promise<unknown>;
  delete(id: string): Promise<unknown>;
}

/** Records of an IndexedDB database, which is opened for each operation. @param name - of the database */
export function keyedStore<T extends { readonly id: string }>(name: string): KeyedStore<T> {
  const use = async <R>(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<R>): Promise<R> => {
    const request = indexedDB.open(name, 1);
    request.addEventListener('upgradeneeded', () => request.result.createObjectStore('files', { keyPath: 'id' }));
    const database = await done(request);
    try {
      return await done(act(database.transaction('files', mode).objectStore('files')));
    } finally {
      database.close();
    }
  };
  return {
    all: () => use('readonly', (store) => store.getAll()) as Promise<T[]>,
    put: (record) => use('readwrite', (store) => store.put(record)),
    delete: (id) => use('readwrite', (store) => store.delete(id)),
  };
}
