import { byExtent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { test as own } from '../support/test';
import { addObject, openEditor, serialized, waitUntilReady } from './editor';
import { dropFiles, growingBox, pixelAt, plainSky, redBox } from './models';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

/** The part of the status bar that says that drafts are not kept. */
const status = (page: Page) => page.getByRole('contentinfo').getByRole('button', { name: /no drafts/ });

const drafts = (page: Page): Promise<void> =>
  expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);

for (const { lacks, text, hide, tag = '' } of [
  {
    lacks: 'IndexedDB',
    text: 'it has no IndexedDB, as in some private windows',
    hide: () => Object.defineProperty(window, 'indexedDB', { value: undefined }),
  },
  {
    lacks: 'Web Locks',
    text: 'it has no Web Locks, which pages have only over https',
    hide: () => Object.defineProperty(navigator, 'locks', { value: undefined }),
    tag: ' @verify',
  },
]) {
  own(`without ${lacks} the editor says that no drafts are kept${tag}`, async ({ page }) => {
    await page.addInitScript(hide);
    await openEditor(page, 'empty');
    const said = `This browser keeps no drafts here: ${text}. Save to a file by Ctrl+S.`;
    await expect(page.locator('.notices')).toHaveText(said);
    await expect(status(page)).toHaveAttribute('title', said);
    expect(await axeProblems(page)).toEqual([]);
    // the message goes, the status stays and gives the message again
    await page.getByRole('button', { name: 'Close message' }).click();
    await expect(page.locator('.notices')).toHaveText('');
    await status(page).click();
    await expect(page.locator('.notices')).toHaveText(said);
    expect(await page.evaluate(() => window.editor.autosave)).toBe(null);
  });
}

own(
  'a draft that the browser refuses for its quota is told of with the reason, and kept later, in each scene',
  async ({ page }) => {
    await openEditor(page, 'empty');
    await drafts(page);
    const [worker] = page.workers();
    // as Chromium does it: without a message
    await worker.evaluate(() => {
      const put = IDBObjectStore.prototype.put;
      IDBObjectStore.prototype.put = function (this: IDBObjectStore, ...args: [unknown, IDBValidKey?]) {
        if (Reflect.get(self, 'isFull')) throw new DOMException('', 'QuotaExceededError');
        return put.apply(this, args);
      };
    });
    const fill = (isFull: boolean): Promise<void> =>
      worker.evaluate((isFull) => void Object.assign(self, { isFull }), isFull);
    const notices = page.locator('.notices');
    const commits = (): Promise<number> => page.evaluate(() => window.editor.autosave!.statistics.commits);

    for (const scene of byExtent({ slice: ['first'], verify: ['first', 'second'] })) {
      await fill(true);
      await addObject(page, 'Mesh', 'Torus');
      await expect(notices, scene).toContainText(
        /This browser keeps no drafts here since [\d:APM\s ]+: it has no room left for this page; free space on the disk\. Save/,
      );
      await expect(status(page)).toContainText(/no drafts since \d/);
      const before = await commits();

      // nobody does anything: it is tried again
      await fill(false);
      await expect(notices).toContainText('Drafts are stored again.');
      await expect(notices).not.toContainText('no drafts');
      await expect(status(page)).toHaveCount(0);
      await drafts(page);
      expect(await commits()).toBeGreaterThan(before);
      const opened = page.evaluate(async () => {
        const text = window.editor.serialize();
        await window.editor.openFileBytes(text, { name: null, handle: null });
      });
      await page.getByRole('dialog').getByRole('button', { name: 'Don’t save' }).click();
      await opened;
      await page.getByRole('button', { name: 'Close message' }).click();
    }
  },
);

own(
  'two tabs of one minute are two different lines in the dialog, and each comes back @verify',
  async ({ page, context }) => {
    const other = await context.newPage();
    for (const [tab, meshes] of [
      [page, ['Torus']],
      [other, ['Torus', 'Cone']],
    ] as const) {
      await openEditor(tab, 'empty');
      for (const mesh of meshes) await addObject(tab, 'Mesh', mesh);
      await drafts(tab);
    }
    await other.close({ runBeforeUnload: false });
    await page.close({ runBeforeUnload: false });

    const next = await context.newPage();
    await openEditor(next, 'empty');
    const lines = next.getByRole('dialog').locator('.session-time');
    await expect(lines).toHaveCount(2);
    const texts = await lines.allTextContents();
    expect(texts.filter((text) => /\d+:\d\d:\d\d.* · 4 objects · last edit: Added Torus$/.test(text))).toHaveLength(1);
    expect(texts.filter((text) => /\d+:\d\d:\d\d.* · 5 objects · last edit: Added Cone$/.test(text))).toHaveLength(1);
    await next.getByRole('button', { name: 'Recover', description: /5 objects/ }).click();
    await expect(next.getByRole('treeitem', { name: 'Cone' })).toBeVisible();
    await next.close({ runBeforeUnload: false });
  },
);

own('a draft that another tab has taken is said to be, by its name @verify', async ({ page, context }) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Torus');
  await page.waitForFunction(() => window.editor.autosave!.isUpToDate);
  await page.close();
  const tabs = [await context.newPage(), await context.newPage()];
  for (const tab of tabs) {
    await tab.goto('./');
    await waitUntilReady(tab);
    await expect(tab.getByRole('button', { name: 'Recover' })).toBeVisible();
  }
  const [first, second] = tabs;
  await first.getByRole('button', { name: 'Recover' }).click();
  await expect(first.getByRole('treeitem', { name: 'Torus' })).toBeVisible();
  await first.waitForFunction(() => window.editor.autosave!.isUpToDate);
  await second.getByRole('button', { name: 'Recover' }).click();
  await expect(second.locator('.notices')).toContainText(
    'Untitled is not here any more: another tab has recovered or discarded it.',
  );
  await expect(second.getByRole('treeitem', { name: 'Torus' })).toHaveCount(0);
});

test('what is dragged and typed is stored while that goes on', async ({ page }) => {
  await drafts(page);
  const seen = await page.evaluate(async () => {
    const { commands, document, autosave } = window.editor as unknown as {
      commands: { begin(): { preview(command: object): void; discard(): void }; isDirty: boolean };
      document: { scene: { roots: { transform: { position: number[] } }[] } };
      autosave: { statistics: { commits: number }; stored: { subscribe(listener: () => void): void } };
    };
    const [object] = document.scene.roots;
    const gesture = commands.begin();
    let x = 0;
    const count = { commits: 0 };
    autosave.stored.subscribe(() => count.commits++);
    const command = {
      label: 'Drag',
      isEmpty: false,
      do: () => (object.transform.position = [++x, 0, 0]),
      undo: () => {},
    };
    while (count.commits < 3) {
      gesture.preview(command);
      await new Promise(requestAnimationFrame);
    }
    const result = { isDirty: commands.isDirty, x };
    gesture.discard();
    return result;
  });
  expect(seen.isDirty, 'the drag is still going on').toBe(false);
  expect(seen.x).toBeGreaterThan(3);
});

/** Ends the process of a page, which hears nothing of it. */
async function kill(page: Page): Promise<void> {
  const cdp = await page.context().newCDPSession(page);
  const crashed = page.waitForEvent('crash');
  // never answered: nobody is left to
  void cdp.send('Page.crash').catch(() => {});
  await crashed;
  await page.close();
}

/** Whether the middle of the picture, with no handles over it, is the red of the box, lit by the white sky. */
async function showsRed(page: Page): Promise<boolean> {
  const [red, green, blue] = await pixelAt(page, 0.5, 0.5);
  return red > 60 && red > 2 * Math.max(green, blue);
}

/** Paths of the files in each draft that the browser holds. */
const draftFiles = (page: Page): Promise<string[][]> =>
  page.evaluate(async () => {
    const { store } = window.editor.autosave as unknown as {
      store: {
        send(request: { kind: 'list' }): Promise<{ id: string }[]>;
        read(id: string): Promise<{ files: Map<string, Blob> }>;
      };
    };
    const stored = await Promise.all((await store.send({ kind: 'list' })).map(({ id }) => store.read(id)));
    return stored.map(({ files }) => [...files].flatMap(([path, { size }]) => (size > 0 ? [path] : [])).toSorted());
  });

own(
  'imported files are in the draft: models and skies of a killed tab come back and are drawn',
  async ({ page, context }) => {
    await openEditor(page, 'empty');
    await dropFiles(page, '.viewport-place canvas', [redBox()]);
    await expect(page.getByRole('treeitem', { name: 'box' })).toBeVisible();
    await drafts(page);
    // into a draft that is stored already
    await dropFiles(page, '.viewport-place canvas', [growingBox(), plainSky(1)]);
    await expect(page.getByRole('treeitem', { name: 'growing' })).toBeVisible();
    await page.waitForFunction(() => window.editor.document.scene.settings.get('environment') !== null);
    await page.keyboard.press('q');
    await expect.poll(() => showsRed(page)).toBe(true);
    await drafts(page);
    const work = await serialized(page);
    await kill(page);

    const next = await context.newPage();
    await openEditor(next, 'empty');
    await next.getByRole('dialog').getByRole('button', { name: 'Recover' }).click();
    await expect(next.getByRole('treeitem', { name: 'box' })).toBeVisible();
    expect(await serialized(next)).toBe(work);
    await expect.poll(() => showsRed(next)).toBe(true);
    // the draft of what was recovered takes the place of the other, and has them too
    await drafts(next);
    const paths = await next.evaluate(() => window.editor.document.assets.files.map(({ name }) => `assets/${name}`));
    expect(paths).toHaveLength(3);
    expect(await draftFiles(next)).toEqual([paths.toSorted()]);
  },
);
