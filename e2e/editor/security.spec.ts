import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { expect, test, type Watch } from '../support/test';
import { openEditor, serialized, waitUntilReady } from './editor';

test.use({ viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' });

const HOST = 'https://pictures.example';

/** A link to a scene with textures of another host on its box. */
async function foreignLink(page: Page): Promise<string> {
  await openEditor(page, 'empty');
  const scene = JSON.parse(await serialized(page)) as {
    assets: object[];
    objects: { name: string; components: object[] }[];
  };
  scene.assets = ['photo', 'bumps'].map((name) => ({ name, type: 'texture', url: `${HOST}/${name}.png` }));
  const [camera] = scene.objects;
  camera.components.push({
    type: 'ObjectRenderer',
    version: 1,
    id: 'a-box',
    values: { map: 'photo', normalMap: 'bumps' },
  });
  return `#scene=${deflateRawSync(JSON.stringify(scene)).toString('base64url')}`;
}

/** Answers for the other host. @returns the addresses that were asked for */
async function answerFor(page: Page): Promise<string[]> {
  const asked: string[] = [];
  const pixel = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==';
  await page.context().route(`${HOST}/**`, (route) => {
    asked.push(route.request().url());
    return route.fulfill({
      body: Buffer.from(pixel, 'base64'),
      contentType: 'image/png',
      headers: { 'Access-Control-Allow-Origin': '*' },
    });
  });
  return asked;
}

/** Opens an address anew, though only what follows '#' may differ. */
async function open(page: Page, address: string): Promise<void> {
  await page.goto('about:blank');
  await page.goto(address);
}

test('a scene from elsewhere asks once before it loads from other hosts; without them the rest opens @verify', async ({
  page,
}) => {
  const asked = await answerFor(page);
  const link = await foreignLink(page);

  await test.step('editor', async () => {
    await open(page, `./${link}`);
    const dialog = page.getByRole('dialog', { name: 'asks for files of other hosts' });
    await expect(dialog.getByRole('list', { name: 'Hosts' })).toHaveText(`${HOST} photo, bumps`);
    expect(asked).toEqual([]);
    await dialog.getByRole('button', { name: 'Open without them' }).click();
    await expect(page.getByText(HOST).first()).toBeVisible();
    await waitUntilReady(page);
    expect(await page.evaluate(() => window.editor.document.scene.assets.list('texture'))).toContain('photo');
    expect(asked).toEqual([]);

    await open(page, `./${link}`);
    await page.getByRole('button', { name: 'Load from these hosts' }).click();
    await expect.poll(() => asked.length).toBe(2);
    await expect(page.getByRole('dialog')).toHaveCount(0);
  });

  await test.step('player', async () => {
    asked.length = 0;
    await open(page, `./player.html${link}`);
    await expect(page.getByRole('dialog')).toContainText(HOST);
    await page.getByRole('button', { name: 'Open without them' }).click();
    await expect(page.getByRole('alert')).toContainText(HOST);
    await expect(page).toHaveTitle('Untitled');
    expect(asked).toEqual([]);
    await open(page, `./player.html${link}`);
    await page.getByRole('button', { name: 'Load from these hosts' }).click();
    await expect.poll(() => asked.length).toBe(2);
    await expect(page).toHaveTitle('Untitled');
  });
});

/** Whether a script that was put into the page runs. */
const ran = (page: Page): Promise<boolean> =>
  page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.injected = true';
    document.body.append(script);
    return 'injected' in window;
  });

/** Whether the page may fetch from an address. */
const fetched = (page: Page, address: string): Promise<boolean> =>
  page.evaluate(
    (url) =>
      fetch(url)
        .then(() => true)
        .catch(() => false),
    address,
  );

const forgive = (watch: Watch): number => watch.forgive(/Content Security Policy/);

test('scripts that come into a page do not run, nor does it fetch from hosts that it was not given', async ({
  page,
  watch,
}, info) => {
  await answerFor(page);
  // the development server puts scripts of its own into the pages that it serves
  const isServed = process.env.FAROL_E2E !== 'built';
  const link = await foreignLink(page);
  expect(await ran(page), 'editor').toBe(isServed);
  await open(page, process.env.FAROL_VIEWER_URL!);
  expect(await ran(page), 'viewer').toBe(isServed);
  forgive(watch);

  await open(page, `./player.html${link}`);
  await page.getByRole('button', { name: 'Load from these hosts' }).click();
  await expect(page).toHaveTitle('Untitled');
  expect(await ran(page), 'player').toBe(false);
  expect(await fetched(page, `${HOST}/photo.png`), 'a host that was allowed').toBe(true);
  expect(forgive(watch)).toBeGreaterThan(0);
  expect(await fetched(page, 'https://other.example/'), 'another host').toBe(false);
  expect(forgive(watch)).toBeGreaterThan(0);

  await open(page, `./${link}`);
  await page.getByRole('button', { name: 'Load from these hosts' }).click();
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = info.outputPath('scene.html');
  await (await download).saveAs(html);
  await open(page, pathToFileURL(html).href);
  await expect(page).toHaveTitle('Untitled');
  expect(await ran(page), 'exported page').toBe(false);
  expect(await fetched(page, `${HOST}/photo.png`), 'a host of the scene').toBe(true);
  expect(forgive(watch)).toBeGreaterThan(0);
  expect(await fetched(page, 'https://other.example/'), 'another host').toBe(false);
  expect(forgive(watch)).toBeGreaterThan(0);
});

/** A script that tries each way in which a page can reach a host. */
const spy = `import { component } from '@farol/engine/fields';
export default class Spy extends component({}) {
  async start() {
    document.body.dataset.ran = 'yes';
    const get = "fetch('${HOST}/worker').catch(() => {}).finally(() => postMessage(''))";
    const ways = {
      fetch: () => fetch('${HOST}/fetch', { method: 'POST', body: 'x', mode: 'no-cors' }),
      beacon: () => navigator.sendBeacon('${HOST}/beacon', 'x'),
      picture: () => new Promise((resolve) => Object.assign(new Image(), { onload: resolve, onerror: resolve, src: '${HOST}/picture' })),
      socket: () => new Promise((resolve) => (new WebSocket('wss://pictures.example/').onerror = resolve)),
      events: () => new Promise((resolve) => (new EventSource('${HOST}/events').onerror = resolve)),
      worker: () => new Promise((resolve) => (new Worker(URL.createObjectURL(new Blob([get]))).onmessage = resolve)),
      frame: () => new Promise((resolve) => document.body.append(Object.assign(document.createElement('iframe'), { onload: resolve, src: '${HOST}/frame' }))),
    };
    for (const way of Object.values(ways)) try { await way(); } catch {}
    console.error('tried all; peers: ' + typeof RTCPeerConnection);
    location.href = '${HOST}/away';
  }
}`;

test('the scripts of a link wait for a click, and then reach no host that was not asked for @verify', async ({
  page,
  watch,
}) => {
  const asked = await answerFor(page);
  await openEditor(page, 'empty');
  const scene = JSON.parse(await serialized(page)) as { assets: object[]; objects: { components: object[] }[] };
  scene.assets = [{ name: 'Spy', type: 'script', values: { source: spy } }];
  scene.objects[0].components.push({ type: 'Spy', version: 1, id: 'a-spy', values: {} });
  const hash = `#scene=${deflateRawSync(JSON.stringify(scene)).toString('base64url')}`;
  for (const player of ['player.html', 'player-scripts.html']) {
    await open(page, `./${player}${hash}`);
    const frame = page.frameLocator('iframe').first();
    const question = frame.getByRole('dialog', { name: 'Scripts of the scene' });
    await expect(question).toContainText('programs of whoever made the link');
    await expect(frame.locator('body')).not.toHaveAttribute('data-ran');
    await question.getByRole('button', { name: 'Open without them' }).click();
    await expect(frame.locator('canvas')).toHaveAttribute('aria-label', 'Untitled');
    await expect(frame.locator('body')).not.toHaveAttribute('data-ran');
  }
  await open(page, `./player.html${hash}`);
  const frame = page.frameLocator('iframe').first();
  await frame.getByRole('button', { name: 'Run them' }).click();
  const seen = (pattern: RegExp): number => watch.problems.findIndex((problem) => pattern.test(problem));
  await expect.poll(() => seen(/tried all; peers: undefined/)).toBeGreaterThan(-1);
  const ways = watch.problems.splice(0, seen(/tried all/) + 1);
  expect(ways.filter((problem) => /Framing 'https:\/\/pictures\.example/.test(problem))).not.toEqual([]);
  // the frame leads itself away
  await expect.poll(() => seen(/Framing 'https:\/\/pictures\.example/)).toBeGreaterThan(-1);
  expect(asked).toEqual([]);
  watch.forgive(/Content Security Policy|tried all/);
});
