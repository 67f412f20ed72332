import { expect, test } from 'vitest';
import type { ViteDevServer } from 'vite';
import { frameHeaders, securePages } from './contentSecurityPolicy.mjs';

const own = { 'content-security-policy': "frame-ancestors 'self'" };

test('pages are shown in frames of their own host alone, but for those that are made to be embedded', () => {
  for (const path of ['/', '/index.html', '/stage.html?x', '/player.html/../index.html', '/xplayer.html'])
    expect(frameHeaders(path), path).toEqual(own);
  for (const path of ['/player.html', '/player-scripts.html?x']) expect(frameHeaders(path), path).toEqual({});
});

test('the development server sends it with its pages', () => {
  const used: ((request: object, response: object, next: () => void) => void)[] = [];
  const { configureServer } = securePages() as { configureServer(server: ViteDevServer): void };
  configureServer({ middlewares: { use: (middleware: never) => used.push(middleware) } } as unknown as ViteDevServer);
  const sent: Record<string, string> = {};
  let goesOn = false;
  used[0]({ url: '/' }, { setHeader: (name: string, value: string) => (sent[name] = value) }, () => (goesOn = true));
  expect(sent).toEqual(own);
  expect(goesOn).toBe(true);
});
