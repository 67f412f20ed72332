import { mkdtempSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { serveFolder } from './benchServe.mjs';

let folder: string;
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'farol-serve-'));
  mkdirSync(join(folder, 'dist'));
  writeFileSync(join(folder, 'dist/index.html'), 'the page');
  writeFileSync(join(folder, 'secret.txt'), 'not for you');
  mkdirSync(join(folder, 'dist-secret'));
  writeFileSync(join(folder, 'dist-secret/index.html'), 'not for you');
});
afterEach(() => rmSync(folder, { recursive: true }));

/** Status of a path as it stands; fetch would take the dots out. */
const status = (url: string, path: string) =>
  new Promise((done) => request(url, { path }, (answer) => done(answer.resume().statusCode)).end());

it('serves a folder and nothing outside of it, isolated for a fine clock', async () => {
  const server = await serveFolder(join(folder, 'dist'));
  try {
    const page = await fetch(`${server.url}?scene=temple`);
    expect(await page.text()).toBe('the page');
    expect(page.headers.get('content-type')).toMatch(/^text\/html/);
    expect(page.headers.get('cross-origin-embedder-policy')).toBe('require-corp');
    expect(page.headers.get('content-security-policy')).toBe("frame-ancestors 'self'");
    expect(await status(server.url, '/missing.js')).toBe(404);
    for (const path of ['/../secret.txt', '/%2e%2e/secret.txt', '/..%2fsecret.txt', '/..%5csecret.txt', '/%']) {
      expect(await status(server.url, path), path).toBe(404);
    }
    // a folder whose path begins as the served one's does
    expect(await status(server.url, '/..%2fdist-secret/index.html')).toBe(404);
  } finally {
    await server.close();
  }
});

it('serves another folder under its name, and nothing above it', async () => {
  mkdirSync(join(folder, 'other'));
  writeFileSync(join(folder, 'other/index.html'), 'the other page');
  const server = await serveFolder(join(folder, 'dist'), { beside: { against: join(folder, 'other') } });
  try {
    expect(await (await fetch(server.url)).text()).toBe('the page');
    expect(await (await fetch(`${server.url}against/`)).text()).toBe('the other page');
    expect(await (await fetch(`${server.url}against/index.html`)).text()).toBe('the other page');
    for (const path of ['/against/../../secret.txt', '/against/..%2fsecret.txt', '/against', '/other/index.html']) {
      expect(await status(server.url, path), path).toBe(404);
    }
  } finally {
    await server.close();
  }
});

it('answers texts in place of files, as they are when they are asked for', async () => {
  let text = 'first';
  const server = await serveFolder(join(folder, 'dist'), { texts: { 'apps.json': () => text } });
  try {
    expect(await (await fetch(`${server.url}apps.json`)).text()).toBe('first');
    text = 'second';
    const answer = await fetch(`${server.url}apps.json`);
    expect(await answer.text()).toBe('second');
    expect(answer.headers.get('content-type')).toBe('application/json');
    expect(await status(server.url, '/constructor')).toBe(404);
  } finally {
    await server.close();
  }
});
