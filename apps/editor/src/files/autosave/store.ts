import type { SessionInfo } from '../../model/SessionInfo';
import { done, refused } from '../keyedStore';
import { mergeParts, type PartChange, type PartKey } from './parts';

const NAME = 'farol-autosave';

/** Key of the record that holds all parts of a session's first write, as an array of [key, JSON]. */
const BASE = 'base';

const finished = (transaction: IDBTransaction): Promise<void> =>
  new Promise((resolve, reject) => {
    transaction.addEventListener('complete', () => resolve());
    // the transaction knows its error only once aborted
    transaction.addEventListener('error', ({ target }) => reject(refused((target as IDBRequest).error)));
    transaction.addEventListener('abort', () => reject(refused(transaction.error)));
  });

let database: Promise<IDBDatabase> | null = null;

/** Opens the database: `sessions` by id; `parts` and `files` by session and key. Tries again after it failed or was closed. */
function open(): Promise<IDBDatabase> {
  database ??= connect().catch((error: unknown) => {
    database = null;
    throw error;
  });
  return database;
}

async function connect(): Promise<IDBDatabase> {
  const request = indexedDB.open(NAME, 1);
  request.addEventListener('upgradeneeded', () => {
    const { result } = request;
    result.createObjectStore('sessions', { keyPath: 'id' });
    result.createObjectStore('parts');
    result.createObjectStore('files');
  });
  const opened = await done(request);
  const forget = (): void => {
    database = null;
  };
  // the user cleared the browser's data, or the disk failed
  opened.addEventListener('close', forget);
  opened.addEventListener('versionchange', () => {
    opened.close();
    forget();
  });
  return opened;
}

const all = (session: string): IDBKeyRange => IDBKeyRange.bound([session], [session, []]);

/**
 * Writes changes of a session as one transaction.
 * @param parts - null removes a part
 * @param files - null removes a file
 * @param isFirst - whether the session is new: its parts are written as one record, much faster than thousands
 */
export async function writeSession(
  info: SessionInfo,
  parts: ReadonlyMap<PartKey, string | null>,
  files: ReadonlyMap<string, Blob | null>,
  isFirst: boolean,
): Promise<void> {
  await write((sessions, store, blobs) => {
    sessions.put(info);
    if (isFirst) {
      store.delete(all(info.id));
      store.put([...parts], [info.id, BASE]);
    } else for (const [key, json] of parts) store.put(json, [info.id, key]);
    for (const [path, blob] of files) {
      if (blob === null) blobs.delete([info.id, path]);
      else blobs.put(blob, [info.id, path]);
    }
  });
}

/** All sessions, newest first. */
export async function listSessions(): Promise<SessionInfo[]> {
  const transaction = (await open()).transaction('sessions');
  const sessions = (await done(transaction.objectStore('sessions').getAll())) as SessionInfo[];
  return sessions.toSorted((a, b) => b.time - a.time);
}

export async function readSession(id: string): Promise<{ parts: Map<PartKey, string>; files: Map<string, Blob> }> {
  const transaction = (await open()).transaction(['parts', 'files']);
  const read = async <T>(name: string): Promise<Map<string, T>> => {
    const store = transaction.objectStore(name);
    const [keys, values] = await Promise.all([done(store.getAllKeys(all(id))), done(store.getAll(all(id)))]);
    return new Map(keys.map((key, i) => [(key as [string, string])[1], values[i] as T]));
  };
  const [parts, files] = await Promise.all([read<string | null>('parts'), read<Blob>('files')]);
  const base = (parts.get(BASE) ?? []) as unknown as readonly PartChange[];
  parts.delete(BASE);
  return { parts: mergeParts(base, parts), files };
}

export async function deleteSession(id: string): Promise<void> {
  await write((sessions, parts, files) => {
    sessions.delete(id);
    parts.delete(all(id));
    files.delete(all(id));
  });
}

/** Writes in one transaction: nothing is stored when anything is refused. */
async function write(
  act: (sessions: IDBObjectStore, parts: IDBObjectStore, files: IDBObjectStore) => void,
): Promise<void> {
  const transaction = (await open()).transaction(['sessions', 'parts', 'files'], 'readwrite');
  const end = finished(transaction);
  try {
    act(transaction.objectStore('sessions'), transaction.objectStore('parts'), transaction.objectStore('files'));
  } catch (error) {
    end.catch(() => {});
    transaction.abort();
    throw error;
  }
  await end;
}
