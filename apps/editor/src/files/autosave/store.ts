import type { PartChange, PartKey } from './parts';

/** What is known of an autosave without reading it. */
export interface SessionInfo {
  readonly id: string;
  /** Name of the scene. */
  readonly name: string;
  /** The file that it was last saved to; null for none. */
  readonly fileName: string | null;
  readonly handle: FileSystemFileHandle | null;
  /** When it was last written (ms since 1970). */
  readonly time: number;
  /** Whether it has changes that are in no file. */
  readonly isDirty: boolean;
}

const NAME = 'farol-autosave';

const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(request.error ?? new Error('The browser refused to store.')));
  });

const finished = (transaction: IDBTransaction): Promise<void> =>
  new Promise((resolve, reject) => {
    transaction.addEventListener('complete', () => resolve());
    const fail = (): void => reject(transaction.error ?? new Error('The browser refused to store.'));
    transaction.addEventListener('error', fail);
    transaction.addEventListener('abort', fail);
  });

let database: Promise<IDBDatabase> | null = null;

/** The store: `sessions` by id; `parts` and `files` by session and key. */
function open(): Promise<IDBDatabase> {
  if (database) return database;
  const request = indexedDB.open(NAME, 1);
  request.addEventListener('upgradeneeded', () => {
    const { result } = request;
    result.createObjectStore('sessions', { keyPath: 'id' });
    result.createObjectStore('parts');
    result.createObjectStore('files');
  });
  database = done(request);
  return database;
}

const all = (session: string): IDBKeyRange => IDBKeyRange.bound([session], [session, []]);

/** Writes changes of a session as one transaction: all of them, or none. @param files - null takes one out */
export async function writeSession(
  info: SessionInfo,
  parts: readonly PartChange[],
  files: ReadonlyMap<string, Blob | null>,
): Promise<void> {
  const transaction = (await open()).transaction(['sessions', 'parts', 'files'], 'readwrite');
  transaction.objectStore('sessions').put(info);
  const store = transaction.objectStore('parts');
  for (const [key, json] of parts) {
    if (json === null) store.delete([info.id, key]);
    else store.put(json, [info.id, key]);
  }
  const blobs = transaction.objectStore('files');
  for (const [path, blob] of files) {
    if (blob === null) blobs.delete([info.id, path]);
    else blobs.put(blob, [info.id, path]);
  }
  await finished(transaction);
}

/** Every session, newest first. */
export async function listSessions(): Promise<SessionInfo[]> {
  const transaction = (await open()).transaction('sessions');
  const sessions = (await done(transaction.objectStore('sessions').getAll())) as SessionInfo[];
  return sessions.toSorted((a, b) => b.time - a.time);
}

/** All that is stored of a session. */
export async function readSession(id: string): Promise<{ parts: Map<PartKey, string>; files: Map<string, Blob> }> {
  const transaction = (await open()).transaction(['parts', 'files']);
  const read = async <T>(name: string): Promise<Map<string, T>> => {
    const store = transaction.objectStore(name);
    const [keys, values] = await Promise.all([done(store.getAllKeys(all(id))), done(store.getAll(all(id)))]);
    return new Map(keys.map((key, i) => [(key as [string, string])[1], values[i] as T]));
  };
  const [parts, files] = await Promise.all([read<string>('parts'), read<Blob>('files')]);
  return { parts, files };
}

/** Forgets a session. */
export async function deleteSession(id: string): Promise<void> {
  const transaction = (await open()).transaction(['sessions', 'parts', 'files'], 'readwrite');
  transaction.objectStore('sessions').delete(id);
  transaction.objectStore('parts').delete(all(id));
  transaction.objectStore('files').delete(all(id));
  await finished(transaction);
}
