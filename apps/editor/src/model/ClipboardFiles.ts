/** Name of the IndexedDB database with the files of the last copy, which other tabs read. */

const NAME = 'farol-clipboard';

/** Functions that store the files of copied objects; their code is fetched late. */
export interface ClipboardFiles {
  readFile(name: string): Promise<Blob | null>;
  writeFiles(files: ReadonlyMap<string, Blob>): Promise<void>;
}

const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(request.error ?? new Error('The browser refused to store data.')));
  });

const ended = (transaction: IDBTransaction): Promise<void> =>
  new Promise((resolve, reject) => {
    transaction.addEventListener('complete', () => resolve());
    transaction.addEventListener('abort', () =>
      reject(transaction.error ?? new Error('The browser refused to store data.')),
    );
  });

async function open(): Promise<IDBDatabase> {
  const request = indexedDB.open(NAME, 1);
  request.addEventListener('upgradeneeded', () => request.result.createObjectStore('files'));
  return done(request);
}

/** @returns null when no stored file has this name */
export async function readFile(name: string): Promise<Blob | null> {
  const database = await open();
  try {
    const found: unknown = await done(database.transaction('files').objectStore('files').get(name));
    return found instanceof Blob ? found : null;
  } finally {
    database.close();
  }
}

/** Replaces the stored files. A file whose name is stored already is not written again. */
export async function writeFiles(files: ReadonlyMap<string, Blob>): Promise<void> {
  const database = await open();
  try {
    const transaction = database.transaction('files', 'readwrite');
    const end = ended(transaction);
    const store = transaction.objectStore('files');
    const there = new Set((await done(store.getAllKeys())).map(String));
    for (const name of there) if (!files.has(name)) store.delete(name);
    for (const [name, blob] of files) if (!there.has(name)) store.put(blob, name);
    await end;
  } finally {
    database.close();
  }
}
