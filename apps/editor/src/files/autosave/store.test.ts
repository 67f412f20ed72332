import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import type { SessionInfo } from '../../model/SessionInfo';
import { deleteSession, listSessions, readSession, writeSession } from './store';

type Key = string | readonly string[];
type Records = Map<string, unknown>;
type Way = 'its value cannot be copied' | 'its request fails' | 'the disk is full at the end';

/** How writes are refused; null when they succeed. */
let refusing: Way | null = null;

/** Fake IndexedDB: stores by name, with records as JSON by key. */
const stores = new Map<string, Records>();

const quota = (): DOMException => new DOMException('', 'QuotaExceededError');

/** A transaction on copies of its stores, which replace the stores when it completes. */
class FakeTransaction extends EventTarget {
  error: DOMException | null = null;
  private readonly copies = new Map<string, Records>();
  private waiting = 0;
  private isOver = false;

  constructor(names: readonly string[]) {
    super();
    for (const name of names) this.copies.set(name, new Map(stores.get(name)));
  }

  objectStore(name: string) {
    const records = this.copies.get(name)!;
    const within = ([first]: readonly string[]): string[] =>
      [...records.keys()].filter((key) => (JSON.parse(key) as Key)[0] === first).toSorted();
    return {
      put: (value: unknown, key: Key = (value as SessionInfo).id) => {
        if (refusing === 'its value cannot be copied' && value instanceof Blob)
          throw new DOMException('', 'DataCloneError');
        const fails = refusing === 'its request fails' && value instanceof Blob;
        return this.ask(() => records.set(JSON.stringify(key), value), fails);
      },
      delete: (key: Key) =>
        this.ask(() => {
          for (const each of key.length === 1 ? within(key as string[]) : [JSON.stringify(key)]) records.delete(each);
        }),
      getAll: (range?: readonly string[]) =>
        this.ask(() => (range ? within(range) : [...records.keys()]).map((key) => records.get(key))),
      getAllKeys: (range: readonly string[]) => this.ask(() => within(range).map((key) => JSON.parse(key) as Key)),
    };
  }

  abort(): void {
    if (this.isOver) return;
    this.isOver = true;
    this.dispatchEvent(new Event('abort'));
  }

  private ask<T>(act: () => T, fails = false) {
    const request = Object.assign(new EventTarget(), { result: fails ? null : act(), error: fails ? quota() : null });
    this.waiting++;
    queueMicrotask(() => {
      if (this.isOver) return;
      if (fails) {
        const event = new Event('error');
        Object.defineProperty(event, 'target', { value: request });
        this.dispatchEvent(event);
        this.error = request.error;
        this.abort();
      } else request.dispatchEvent(new Event('success'));
      if (--this.waiting === 0) this.end();
    });
    return request;
  }

  private end(): void {
    if (this.isOver) return;
    if (refusing === 'the disk is full at the end' && this.copies.has('files')) {
      this.error = quota();
      this.abort();
      return;
    }
    this.isOver = true;
    for (const [name, records] of this.copies) stores.set(name, records);
    this.dispatchEvent(new Event('complete'));
  }
}

beforeAll(() => {
  const database = Object.assign(new EventTarget(), {
    createObjectStore: (name: string) => void stores.set(name, new Map()),
    transaction: (names: string | readonly string[]) => new FakeTransaction([names].flat()),
    close: () => {},
  });
  vi.stubGlobal('IDBKeyRange', { bound: (lower: readonly string[]) => lower });
  vi.stubGlobal('indexedDB', {
    open: () => {
      const request = Object.assign(new EventTarget(), { result: database });
      queueMicrotask(() => {
        for (const name of ['upgradeneeded', 'success']) request.dispatchEvent(new Event(name));
      });
      return request;
    },
  });
});

afterAll(() => {
  vi.unstubAllGlobals();
});

const info = (time: number): SessionInfo => ({ id: 'a', name: 'Yard', time }) as unknown as SessionInfo;

test('a write of which anything is refused changes nothing', async () => {
  const sky = new Blob(['sky']);
  await writeSession(
    info(1),
    new Map([
      ['o/a', '1'],
      ['o/b', '2'],
    ]),
    new Map([['sky.hdr', sky]]),
    true,
  );
  await writeSession(
    info(2),
    new Map([
      ['o/b', null],
      ['o/c', '3'],
    ]),
    new Map(),
    false,
  );
  const stored = async () => [await listSessions(), await readSession('a')] as const;
  const before = await stored();
  expect(before).toEqual([
    [info(2)],
    {
      parts: new Map([
        ['o/a', '1'],
        ['o/c', '3'],
      ]),
      files: new Map([['sky.hdr', sky]]),
    },
  ]);
  for (const way of ['its value cannot be copied', 'its request fails', 'the disk is full at the end'] as const) {
    refusing = way;
    const files = new Map([
      ['sky.hdr', null],
      ['new.glb', new Blob(['new'])],
    ]);
    const write = writeSession(
      info(3),
      new Map([
        ['o/a', null],
        ['o/d', '4'],
      ]),
      files,
      false,
    );
    await expect(write, way).rejects.toMatchObject({ name: expect.stringMatching(/DataClone|QuotaExceeded/) });
    refusing = null;
    expect(await stored(), way).toEqual(before);
  }
  await deleteSession('a');
  expect([...stores.values()].map(({ size }) => size)).toEqual([0, 0, 0]);
});
