import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { serveFolder } from '@farol/tools/benchServe';
import { offlineApp } from '@farol/tools/offlineApp';
import { root } from '@farol/tools/root';
import { build } from 'vite';
import { expect, test } from '../support/test';
import { waitUntilReady } from './editor';

test.use({ serviceWorkers: 'allow' });

/** Builds an app of one script that writes a text. @returns its folder */
async function buildApp(folder: string, text: string): Promise<string> {
  await mkdir(folder, { recursive: true });
  await writeFile(
    join(folder, 'index.html'),
    '<link rel="icon" href="data:," /><script type="module" src="./main.js"></script>',
  );
  await writeFile(join(folder, 'main.js'), `document.body.append(${JSON.stringify(text)});`);
  const outDir = join(folder, 'dist');
  await build({
    ...{ root: folder, base: './', configFile: false, publicDir: false, logLevel: 'warn' },
    build: { outDir },
    plugins: [offlineApp({ name: 'Test', opens: '.farol' })],
  });
  return outDir;
}

/** Waits until the files that the app needs are kept, and the page is answered from them. */
async function kept(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller)
      await new Promise((resolve) => {
        navigator.serviceWorker.addEventListener('controllerchange', resolve, { once: true });
      });
  });
}

test('a built app works without its server, and offers another version once it is there', async ({
  page,
  watch,
}, info) => {
  const first = await serveFolder(await buildApp(info.outputPath('first'), 'First'), { isolated: false });
  await page.goto(first.url);
  await kept(page);
  await first.close();
  await page.reload();
  await expect(page.getByText('First')).toBeVisible();
  // the browser asks for another version in vain
  watch.forgive(/ERR_CONNECTION_REFUSED/);

  const second = await buildApp(info.outputPath('second'), 'Second');
  const { port } = new URL(first.url);
  const again = await serveFolder(second, { isolated: false, port: Number(port) });
  await page.reload();
  await expect(page.getByText('A new version is there.')).toBeVisible();
  await expect(page.getByText('First')).toBeVisible();
  await page.getByRole('button', { name: 'Reload' }).click();
  await expect(page.getByText('Second')).toBeVisible();
  const manifest = JSON.parse(await readFile(join(second, 'manifest.webmanifest'), 'utf8')) as {
    file_handlers: object[];
  };
  expect(manifest.file_handlers).toHaveLength(1);
  await again.close();
});

// from source the editor has no built files
if (process.env.FAROL_E2E === 'built') {
  test('the editor opens without its server, and a file that the system hands it @verify', async ({ page, watch }) => {
    const built = await serveFolder(join(root, 'apps/editor/dist'), { isolated: false });
    await page.goto(`${built.url}?scene=empty`);
    await waitUntilReady(page);
    await kept(page);
    await built.close();
    await page.addInitScript(() => {
      const file = new File(
        [
          JSON.stringify({
            format: 'farol-scene',
            version: 3,
            name: 'Handed',
            settings: {},
            activeCamera: null,
            assets: [],
            objects: [],
          }),
        ],
        'handed.farol',
      );
      const handle = { kind: 'file', name: 'handed.farol', getFile: () => Promise.resolve(file) };
      const launchQueue = { setConsumer: (take: (launch: object) => void) => take({ files: [handle] }) };
      Object.defineProperty(window, 'launchQueue', { value: launchQueue });
    });
    await page.reload();
    await waitUntilReady(page);
    await expect.poll(() => page.evaluate(() => window.editor.document.scene.name)).toBe('Handed');
    watch.forgive(/ERR_CONNECTION_REFUSED|Failed to update a ServiceWorker/);
  });
}
