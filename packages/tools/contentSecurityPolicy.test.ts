import { expect, test } from 'vitest';
import type { ViteDevServer } from 'vite';
import { contentSecurityPolicy, frameHeaders, securePages } from './contentSecurityPolicy.mjs';

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

/** Sources that a policy allows, by directive. */
const directives = (options?: Parameters<typeof contentSecurityPolicy>[0]): Record<string, string[]> =>
  Object.fromEntries(
    contentSecurityPolicy(options)
      .split('; ')
      .map((directive) => directive.split(' '))
      .map(([name, ...sources]) => [name, sources]),
  );

test('a built page runs its own files, sends no form, has no other base, and reads nothing that is not named', () => {
  const built = {
    'default-src': ["'none'"],
    'script-src': ["'self'", "'wasm-unsafe-eval'"],
    'worker-src': ["'self'", 'blob:'],
    'frame-src': ["'self'"],
    'style-src': ["'self'", "'unsafe-inline'"],
    'img-src': ["'self'", 'data:', 'blob:'],
    'font-src': ["'self'", 'data:'],
    'connect-src': ["'self'", 'data:', 'blob:', 'https:', 'http:'],
    'manifest-src': ["'self'"],
    'base-uri': ["'none'"],
    'form-action': ["'none'"],
  };
  expect(directives()).toEqual(built);
  expect(directives({ runsScripts: true })).toEqual({ ...built, 'script-src': [...built['script-src'], 'blob:'] });
});

test('what is served from source may be written into its pages, and is told of edits', () => {
  const { 'script-src': scripts, 'connect-src': hosts, ...others } = directives({ isServed: true });
  const { 'script-src': builtScripts, 'connect-src': builtHosts, ...builtOthers } = directives();
  expect(scripts).toEqual([...builtScripts, "'unsafe-inline'"]);
  expect(hosts).toEqual([...builtHosts, 'ws:', 'wss:']);
  expect(others).toEqual(builtOthers);
});
