import { Signal } from '@farol/editing';
import { createStore, delMany, get, getMany, promisifyRequest, setMany, type UseStore } from 'idb-keyval';
import type { LabRun } from './LabRun';
import { readRun } from './parseRun';

/** Entry of a run in the list of kept runs. */
export interface RunInfo {
  id: string;
  /** Name given by the user; empty for none. */
  name: string;
  label: string;
  /** Date and time, ISO 8601. */
  date: string;
  device: string;
  browser: string;
  build: string;
  complete: boolean;
  rows: number;
}

export function runInfo({ id, name, plan, surroundings, complete, rows }: LabRun): RunInfo {
  const { date, device, browser, build } = surroundings;
  return { id, name, label: plan.label, date, device, browser, build, complete, rows: rows.length };
}

/** Failure to keep or read runs; the message is a sentence with the remedy. */
export class RunStoreError extends Error {
  override name = 'RunStoreError';
}

const infoKey = (id: string): string => `info:${id}`;
const runKey = (id: string): string => `run:${id}`;

const reasons: Readonly<Record<string, string>> = {
  QuotaExceededError: 'it has no room left for this page. Delete runs, or free space on the disk',
  SecurityError: 'it does not let this page store data, as in some private windows',
  InvalidStateError: 'its storage is closed, as in some private windows',
  VersionError: 'its storage is of a newer version of the Lab. Reload the page',
  UnknownError: 'its storage is damaged, or the disk is full',
};

/** Wraps the browser's error. @param what - beginning of the message, as in "The run was not kept" */
function refused(what: string, error: unknown): RunStoreError {
  const { name, message } = error instanceof Error ? error : new Error(String(error));
  const why = Object.hasOwn(reasons, name) ? reasons[name] : message || 'it did not say why';
  return new RunStoreError(`${what}: the browser refused, since ${why}. Export a run as JSON to keep it.`, {
    cause: error,
  });
}

/**
 * Runs kept in IndexedDB: a short entry for the list and the run itself, always written together. Each method rejects with
 * a {@link RunStoreError} if the browser refuses.
 */
export class RunStore {
  readonly #store: UseStore;
  readonly #kept = new Signal();
  readonly #channel: BroadcastChannel | null;

  /** @param name - name of the database */
  constructor(name = 'farol-lab') {
    let opened: UseStore | null = null;
    // the database is opened on first use: opening throws in a page without storage, which should start nevertheless
    this.#store = async (mode, callback) => (opened ??= createStore(name, 'runs'))(mode, callback);
    this.#channel = typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel(name);
    this.#channel?.addEventListener('message', () => this.#kept.emit());
  }

  /** Calls `listener` when a run was kept, renamed or deleted in any tab. @returns a function that stops it */
  readonly onChange = this.#kept.subscribe;

  /** Keeps a run, replacing one with the same id. */
  async save(run: LabRun): Promise<void> {
    await this.#write('The run was not kept', [
      [infoKey(run.id), runInfo(run)],
      [runKey(run.id), run],
    ]);
  }

  /** Entries of all kept runs, newest first. */
  async list(): Promise<RunInfo[]> {
    const range = IDBKeyRange.bound(infoKey(''), infoKey('\uffff'));
    const infos = await this.#try('The kept runs cannot be listed', () =>
      this.#store('readonly', (store) => promisifyRequest(store.getAll(range) as IDBRequest<RunInfo[]>)),
    );
    return infos.sort((a, b) => b.date.localeCompare(a.date));
  }

  async has(id: string): Promise<boolean> {
    const info: unknown = await this.#try('The kept runs cannot be read', () => get(infoKey(id), this.#store));
    return info !== undefined;
  }

  /** Reads a run. @throws FormatError if the run is of another version of the Lab */
  async open(id: string): Promise<LabRun> {
    const run: unknown = await this.#try('The run cannot be read', () => get(runKey(id), this.#store));
    if (run === undefined) throw new RunStoreError('The run is no longer kept: it was deleted in another tab.');
    return readRun(run);
  }

  /** Renames a run. @param name - cut to 200 characters */
  async rename(id: string, name: string): Promise<void> {
    await this.save({ ...(await this.open(id)), name: name.trim().slice(0, 200) });
  }

  /** Deletes a run. @returns a function that restores it */
  async remove(id: string): Promise<() => Promise<void>> {
    const keys = [infoKey(id), runKey(id)];
    const kept = await this.#try('The run was not deleted', async () => {
      const values = await getMany<unknown>(keys, this.#store);
      await delMany(keys, this.#store);
      return values;
    });
    this.#changed();
    return () =>
      this.#write(
        'The run was not put back',
        keys.map((key, i) => [key, kept[i]]),
      );
  }

  async #write(what: string, entries: [string, unknown][]): Promise<void> {
    await this.#try(what, () => setMany(entries, this.#store));
    this.#changed();
  }

  async #try<T>(what: string, act: () => Promise<T>): Promise<T> {
    try {
      return await act();
    } catch (error) {
      throw refused(what, error);
    }
  }

  #changed(): void {
    this.#channel?.postMessage(null);
    this.#kept.emit();
  }
}
