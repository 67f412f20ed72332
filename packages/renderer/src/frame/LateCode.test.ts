import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { LateCode } from './LateCode';

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

const offline = (): Promise<string> => Promise.reject(new Error('offline'));

/** Asks as frames do, every 16 ms. */
async function draw(late: LateCode<string>, milliseconds: number): Promise<void> {
  for (let time = 0; time < milliseconds; time += 16) {
    late.ask();
    await vi.advanceTimersByTimeAsync(16);
  }
}

it('asks again for what could not be fetched, ever more rarely, with one warning', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const fetch = vi.fn<() => Promise<string>>(offline);
  const late = new LateCode<string>(fetch, 'shadow maps', 'three draws them');
  await draw(late, 900);
  expect(fetch).toHaveBeenCalledTimes(1);
  await draw(late, 3000);
  expect(fetch).toHaveBeenCalledTimes(3);
  await draw(late, 600_000);
  expect(fetch.mock.calls.length).toBeLessThan(20);
  expect(warn.mock.calls).toEqual([
    [
      'Farol: the code of shadow maps cannot be fetched; until it can, three draws them (Error: offline). Serve the files of @farol/renderer together.',
    ],
  ]);
  fetch.mockResolvedValue('code');
  await draw(late, 61_000);
  expect(late.code).toBe('code');
  const { length } = fetch.mock.calls;
  await draw(late, 61_000);
  expect(fetch).toHaveBeenCalledTimes(length);
});

it('is fetched at once when it is asked for by name, or the page is online again', async () => {
  vi.spyOn(console, 'warn').mockImplementation(() => {});
  const page = new EventTarget();
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page));
  const fetch = vi.fn<() => Promise<string>>(offline);
  const late = new LateCode<string>(fetch, 'views', 'the picture is shown');
  await draw(late, 100);
  await expect(late.load()).rejects.toThrow('offline');
  expect(fetch).toHaveBeenCalledTimes(2);
  page.dispatchEvent(new Event('online'));
  fetch.mockResolvedValue('code');
  await draw(late, 16);
  expect(late.code).toBe('code');
  expect(await late.load()).toBe('code');
  expect(fetch).toHaveBeenCalledTimes(3);
  vi.unstubAllGlobals();
});

it('is fetched once for all who wait for it', async () => {
  const fetch = vi.fn<() => Promise<string>>(() => Promise.resolve('code'));
  const late = new LateCode<string>(fetch, 'views', 'the picture is shown');
  late.ask();
  expect(await Promise.all([late.load(), late.load()])).toEqual(['code', 'code']);
  expect(fetch).toHaveBeenCalledTimes(1);
});
