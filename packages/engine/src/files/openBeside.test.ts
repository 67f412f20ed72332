import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { handoverMessages, openBeside } from './openBeside';

type Listener = (event: { source: unknown; origin: string; data: unknown }) => void;

/** Stands for the opened window. */
function fakePage() {
  const sent: { message: { type: string; bytes?: ArrayBuffer }; origin: string; transfer: unknown }[] = [];
  return {
    closed: false,
    location: { href: 'about:blank' },
    sent,
    close() {
      this.closed = true;
    },
    postMessage(message: { type: string }, origin: string, transfer?: unknown) {
      sent.push({ message, origin, transfer });
    },
  };
}

function fakeHost(page: ReturnType<typeof fakePage> | null) {
  const listeners = new Set<Listener>();
  return {
    listeners,
    location: { href: 'https://farol.example/viewer/?scene=temple', origin: 'https://farol.example' },
    open: () => page,
    addEventListener: (_: string, listener: Listener) => void listeners.add(listener),
    removeEventListener: (_: string, listener: Listener) => void listeners.delete(listener),
    say(source: unknown, origin: string, data: unknown) {
      for (const listener of listeners) listener({ source, origin, data });
    },
  };
}

const answerWith = (text: string, status = 200): void => {
  vi.stubGlobal('fetch', async () => new Response(text, { status }));
};
const wanted = { type: handoverMessages.wanted };
const scene = { name: 'Room', bytes: async () => new Uint8Array([1, 2, 3]) };

beforeEach(() => {
  vi.useFakeTimers();
  answerWith('{ "lab": "../lab/" }');
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Opens the Lab, up to the address of its window. */
async function open(options = {}) {
  const page = fakePage();
  const host = fakeHost(page);
  const opened = openBeside('lab', 'the Lab', { host: host as never, ...options });
  const outcome = opened.then(
    () => 'opened',
    (error: Error) => error.message,
  );
  await vi.advanceTimersByTimeAsync(1);
  return { page, host, outcome };
}

describe('openBeside', () => {
  it('opens the address that apps.json says, with what follows #', async () => {
    const { page, host, outcome } = await open({ fragment: '#preset=quick' });
    expect(await outcome).toBe('opened');
    expect(page.location.href).toBe('https://farol.example/lab/#preset=quick');
    expect(host.listeners.size).toBe(0);
  });

  it('hands the scene to the window and origin that it opened, as often as it asks', async () => {
    answerWith('{ "lab": "https://lab.example/x/" }');
    const { page, host, outcome } = await open({ scene });
    expect(page.location.href).toBe('https://lab.example/x/?from=https%3A%2F%2Ffarol.example');
    host.say(page, 'https://lab.example', wanted);
    expect(await outcome).toBe('opened');
    const [{ message, origin, transfer }] = page.sent;
    expect(message).toMatchObject({ type: handoverMessages.scene, name: 'Room' });
    expect([...new Uint8Array(message.bytes!)]).toEqual([1, 2, 3]);
    expect(origin).toBe('https://lab.example');
    expect(transfer).toEqual([message.bytes]);
    host.say(page, 'https://lab.example', wanted);
    await vi.advanceTimersByTimeAsync(1);
    expect(page.sent).toHaveLength(2);
    page.close();
    await vi.advanceTimersByTimeAsync(2500);
    expect(host.listeners.size).toBe(0);
  });

  it('answers no other window, origin or message', async () => {
    const { page, host } = await open({ scene });
    host.say({}, 'https://farol.example', wanted);
    host.say(page, 'https://evil.example', wanted);
    host.say(page, 'https://farol.example', 'farol-scene-wanted');
    host.say(page, 'https://farol.example', null);
    await vi.advanceTimersByTimeAsync(1);
    expect(page.sent).toEqual([]);
  });

  it('says that the window was blocked', async () => {
    const opened = openBeside('lab', 'the Lab', { host: fakeHost(null) as never });
    await expect(opened).rejects.toThrow(/^The browser blocked the window of the Lab: allow pop-ups for this page/);
  });

  it.each([
    ['{}', 200],
    ['<!doctype html>', 200],
    ['', 404],
    ['null', 200],
    ['{ "lab": 3 }', 200],
    ['{ "lab": "http://" }', 200],
    ['{ "lab": "javascript:alert(1)" }', 200],
  ])('says that nobody knows the address (%j, %d), and closes the window', async (text, status) => {
    answerWith(text, status);
    const { page, outcome } = await open({ scene });
    expect(await outcome).toMatch(/^The address of the Lab is unknown: .*\/viewer\/apps\.json\.$/);
    expect(page.closed).toBe(true);
  });

  it('says that nobody answers, and yet answers who asks late', async () => {
    const { page, host, outcome } = await open({ scene });
    await vi.advanceTimersByTimeAsync(30_000);
    expect(await outcome).toMatch(
      /^No answer from the Lab at https:\/\/farol\.example\/lab\/\S+: is it served there\?/,
    );
    host.say(page, 'https://farol.example', wanted);
    await vi.advanceTimersByTimeAsync(1);
    expect(page.sent).toHaveLength(1);
  });

  it('tells both sides when the scene cannot be packed', async () => {
    const bytes = () => Promise.reject(new Error('The texture is gone.'));
    const { page, host, outcome } = await open({ scene: { name: 'Room', bytes } });
    host.say(page, 'https://farol.example', wanted);
    expect(await outcome).toBe('The texture is gone.');
    expect(page.sent[0].message).toEqual({ type: handoverMessages.failed, problem: 'The texture is gone.' });
  });
});
