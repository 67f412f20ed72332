import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { receiveScene } from './receiveScene';

type Listener = (event: { source: unknown; origin: string; data: unknown }) => void;
const viewer = 'https://viewer.example';

function fakeHost(search: string, opener: object | null) {
  const listeners = new Set<Listener>();
  return {
    listeners,
    opener,
    location: { href: `https://lab.example/lab/${search}` },
    addEventListener: (_: string, listener: Listener) => void listeners.add(listener),
    removeEventListener: (_: string, listener: Listener) => void listeners.delete(listener),
    say(source: unknown, origin: string, data: unknown) {
      for (const listener of listeners) listener({ source, origin, data });
    },
  };
}

/** The page that opened the Lab. */
function fakeOpener() {
  const asked: [unknown, string][] = [];
  return {
    closed: false,
    asked,
    postMessage: (message: unknown, origin: string) => void asked.push([message, origin]),
  };
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('fetch', async () => new Response(JSON.stringify({ viewer: `${viewer}/`, editor: '../editor/' })));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Begins to receive a scene, up to the request for it. */
async function receive(search: string, opener: ReturnType<typeof fakeOpener> | null = fakeOpener()) {
  const host = fakeHost(search, opener);
  const outcome = receiveScene({ host: host as never }).catch((error: Error) => error.message);
  await vi.advanceTimersByTimeAsync(1);
  return { host, opener, outcome };
}
const fromViewer = `?from=${encodeURIComponent(viewer)}`;
const file = { type: 'farol-scene', name: 'Room', bytes: new Uint8Array([7, 8]).buffer };

describe('receiveScene', () => {
  it('asks for none where the address says none', async () => {
    const { opener, outcome } = await receive('');
    expect(await outcome).toBeNull();
    expect(opener!.asked).toEqual([]);
  });

  it('asks the page that opened it, at its origin alone, and takes the scene', async () => {
    const { host, opener, outcome } = await receive(fromViewer);
    expect(opener!.asked).toEqual([[{ type: 'farol-scene-wanted' }, viewer]]);
    host.say(opener, viewer, file);
    expect(await outcome).toEqual({ name: 'Room', file: new Uint8Array([7, 8]) });
    expect(host.listeners.size).toBe(0);
  });

  it('takes addresses of apps.json relative to itself', async () => {
    const { opener } = await receive(`?from=${encodeURIComponent('https://lab.example')}`);
    expect(opener!.asked).toHaveLength(1);
  });

  it('asks no page of another origin', async () => {
    const { opener, outcome } = await receive('?from=https%3A%2F%2Fevil.example');
    expect(await outcome).toMatch(/^A page of https:\/\/evil\.example offers a scene, and is neither/);
    expect(opener!.asked).toEqual([]);
  });

  it('takes nothing from another window or origin, and no other message', async () => {
    const { host, opener, outcome } = await receive(fromViewer);
    host.say({}, viewer, file);
    host.say(opener, 'https://evil.example', file);
    host.say(opener, viewer, { ...file, bytes: 'text' });
    host.say(opener, viewer, null);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(await outcome).toMatch(/does not answer: choose “Measure this scene” there once more/);
    expect(host.listeners.size).toBe(0);
  });

  it('says that the other page is gone, or could not pack its scene', async () => {
    expect(await (await receive(fromViewer, null)).outcome).toMatch(/is gone: choose/);
    const { host, opener, outcome } = await receive(fromViewer);
    host.say(opener, viewer, { type: 'farol-scene-failed', problem: 'The texture is gone.' });
    expect(await outcome).toBe('The scene was not received: The texture is gone.');
  });

  it('cuts a long name, and gives one to a scene without', async () => {
    for (const [name, kept] of [
      ['x'.repeat(500), 'x'.repeat(120)],
      ['', 'Scene'],
      [3, 'Scene'],
    ]) {
      const { host, opener, outcome } = await receive(fromViewer);
      host.say(opener, viewer, { ...file, name });
      expect(await outcome).toMatchObject({ name: kept });
    }
  });
});
