import { createServer } from 'node:net';
import { readExamples } from '@farol/tools/site/galleryExamples';
import { serveApps } from '@farol/tools/serveApps';
import { expect, test as base } from '../support/test';

/** VitePress takes its own port, which may be in use, where it is told 0. */
const freePort = (): Promise<number> =>
  new Promise((resolve) => {
    const probe = createServer().listen(0, '127.0.0.1', () => {
      const { port } = probe.address() as { port: number };
      probe.close(() => resolve(port));
    });
  });

/** Site and editor as `npm start` serves them: what is published has no editor beside it. */
const test = base.extend<object, { site: string }>({
  site: [
    // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures from the pattern
    async ({}, use) => {
      const { urls, close } = await serveApps({ ports: { editor: 0, site: await freePort() }, watch: false });
      await use(urls.site!);
      await close();
    },
    { scope: 'worker' },
  ],
});

test.use({ viewport: { width: 1000, height: 700 } });

const examples = readExamples().filter(({ editor }) => editor !== null);

test('examples that the editor can open do so by their link @verify', async ({ page, site, watch }) => {
  test.slow();
  expect(examples.length).toBeGreaterThanOrEqual(2);
  for (const { name, editor } of examples) {
    await page.goto(`${site}gallery/${name}.html`);
    const [tab] = await Promise.all([
      page.context().waitForEvent('page'),
      page.getByRole('link', { name: 'Open it in the editor' }).click(),
    ]);
    await tab.waitForFunction(() => 'editor' in window);
    const { scene, size } = await tab.evaluate(async () => {
      await window.editor.ready;
      const { scene } = window.editor.document;
      return { scene: new URLSearchParams(location.search).get('scene'), size: scene.size };
    });
    expect(`?scene=${scene}`, name).toBe(editor);
    expect(size, `objects of ${name}`).toBeGreaterThan(20);
    await tab.close();
  }
  watch.forgive(/favicon\.ico/); // pages that VitePress serves from source name theirs late
});
