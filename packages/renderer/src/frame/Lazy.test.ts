import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Lazy } from './Lazy';

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

interface Code {
  readonly text: string;
}

const CODE: Code = { text: 'code' };
const textOf = (lazy: Lazy<Code>): string | null => lazy.use(({ text }) => text);
const offline = (): Promise<Code> => Promise.reject(new Error('offline'));

/** Calls `use` like frames, every 16 ms. */
async function draw(lazy: Lazy<Code>, milliseconds: number): Promise<void> {
  for (let time = 0; time < milliseconds; time += 16) {
    lazy.ask();
    await vi.advanceTimersByTimeAsync(16);
  }
}

it('asks again for what could not be fetched, ever more rarely, with one warning', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const fetch = vi.fn<() => Promise<Code>>(offline);
  const lazy = new Lazy<Code>('shadows', fetch, 'three draws them');
  await draw(lazy, 900);
  expect(fetch).toHaveBeenCalledTimes(1);
  await draw(lazy, 3000);
  expect(fetch).toHaveBeenCalledTimes(3);
  await draw(lazy, 600_000);
  expect(fetch.mock.calls.length).toBeLessThan(20);
  expect(warn.mock.calls).toEqual([
    [
      'Farol: the code of shadows cannot be fetched; until it can, three draws them (Error: offline). Serve the files of @farol/renderer together.',
    ],
  ]);
  fetch.mockResolvedValue(CODE);
  await draw(lazy, 61_000);
  expect(textOf(lazy)).toBe('code');
  const { length } = fetch.mock.calls;
  await draw(lazy, 61_000);
  expect(fetch).toHaveBeenCalledTimes(length);
});

it('is fetched at once when it is asked for by name, or the page is online again', async () => {
  vi.spyOn(console, 'warn').mockImplementation(() => {});
  const page = new EventTarget();
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page));
  const fetch = vi.fn<() => Promise<Code>>(offline);
  const lazy = new Lazy<Code>('views', fetch, 'the picture is shown');
  await draw(lazy, 100);
  await expect(lazy.load()).rejects.toThrow('offline');
  expect(fetch).toHaveBeenCalledTimes(2);
  page.dispatchEvent(new Event('online'));
  fetch.mockResolvedValue(CODE);
  await draw(lazy, 16);
  expect(textOf(lazy)).toBe('code');
  expect(await lazy.load()).toBe(CODE);
  expect(fetch).toHaveBeenCalledTimes(3);
  vi.unstubAllGlobals();
});

it('is fetched once for all who wait for it', async () => {
  const fetch = vi.fn<() => Promise<Code>>(() => Promise.resolve(CODE));
  const lazy = new Lazy<Code>('views', fetch, 'the picture is shown');
  lazy.ask();
  expect(await Promise.all([lazy.load(), lazy.load()])).toEqual([CODE, CODE]);
  expect(fetch).toHaveBeenCalledTimes(1);
});

it('is used once it is there, and asked for by that until then', async () => {
  const fetch = vi.fn<() => Promise<Code>>(() => Promise.resolve(CODE));
  const lazy = new Lazy<Code>('views', fetch, 'the picture is shown');
  expect(() => lazy.required).toThrow('the code of views is not loaded; await FarolRenderer.preload() first');
  expect(lazy.use(({ text }) => text.length)).toBeNull();
  expect(lazy.isThere).toBe(false);
  await vi.advanceTimersByTimeAsync(0);
  expect(lazy.use(({ text }) => text.length)).toBe(4);
  expect([lazy.required, lazy.isThere, lazy.ask()]).toEqual([CODE, true, true]);
  expect(fetch).toHaveBeenCalledTimes(1);
});
