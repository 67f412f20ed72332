import type { Page } from '@playwright/test';
import type { Light } from '@farol/engine';
import { expect, test } from '../support/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject, history, inspectorFollows, openEditor, serialized, waitUntilReady } from './editor';
import { dropFiles, type TestFile } from './models';
import { test as shared } from './sharedEditor';

const options = { viewport: { width: 1000, height: 600 }, reducedMotion: 'reduce' } as const;
test.use(options);
shared.use(options);

async function openEmpty(page: Page): Promise<void> {
  await page.addInitScript(() => {
    // the fallback, a download, is what a test can answer
    Reflect.deleteProperty(window, 'showOpenFilePicker');
    Reflect.deleteProperty(window, 'showSaveFilePicker');
  });
  await page.goto('./?scene=empty');
  await waitUntilReady(page);
  await page.waitForFunction(() => window.editor.autosave !== null);
}

const TRIANGLE = [
  'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z',
  'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n',
].join('\n');

/** Waits until everything up to now is stored. */
async function stored(page: Page): Promise<void> {
  await page.waitForFunction(() => window.editor.autosave!.isUpToDate);
}

test('what a killed tab leaves is found, recovered, and stored again @verify', async ({ page, context }) => {
  await openEmpty(page);
  await addObject(page, 'Mesh', 'Torus');
  await page.getByLabel('Name', { exact: true }).fill('Precious');
  await page.keyboard.press('Enter');
  await stored(page);
  const work = await serialized(page);
  await page.close({ runBeforeUnload: false });

  const next = await context.newPage();
  await openEmpty(next);
  const dialog = next.getByRole('dialog');
  await expect(dialog).toContainText('Unsaved work was found');
  expect(await axeProblems(next)).toEqual([]);

  // put off, and found again when something else has been begun and stored
  await dialog.getByRole('button', { name: 'Later' }).click();
  await addObject(next, 'Mesh', 'Cone');
  await stored(next);
  await next.getByRole('menuitem', { name: 'File', exact: true }).click();
  await next.getByRole('menuitem', { name: 'Recover…' }).click();
  await expect(dialog).toContainText('Unsaved work was found');
  await dialog.getByRole('button', { name: 'Recover' }).click();
  await dialog.getByRole('button', { name: 'Don’t save' }).click();
  await expect(next.getByRole('treeitem', { name: 'Precious' })).toBeVisible();
  expect(await serialized(next)).toBe(work);
  expect(await next.evaluate(() => window.editor.commands.isDirty)).toBe(true);
  await stored(next);
  await next.close({ runBeforeUnload: false });

  // a live tab's work is not offered to another; a discarded one never again
  const third = await context.newPage();
  await openEmpty(third);
  await third.getByRole('dialog').getByRole('button', { name: 'Discard' }).click();
  await expect(third.getByRole('dialog')).toHaveCount(0);
  await third.reload();
  await waitUntilReady(third);
  await third.waitForFunction(() => window.editor.autosave !== null);
  await expect(third.getByRole('dialog')).toHaveCount(0);
  await third.close();
});

shared('a prefab: made, placed, changed, overridden, applied, reverted', async ({ page }) => {
  await addObject(page, 'Light', 'Point light');
  await page.getByRole('treeitem', { name: 'Point light' }).click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'Make prefab' }).click();
  await expect(page.getByRole('group', { name: 'Prefab' })).toContainText('as the prefab');

  await page.getByRole('tab', { name: 'Assets' }).click();
  await page.getByLabel('Kind of asset').click();
  await page.getByRole('option', { name: 'Prefabs' }).click();
  for (const count of [2, 3]) {
    await page.locator('.asset-card').first().dblclick();
    await expect(page.getByRole('treeitem', { name: 'Point light' })).toHaveCount(count);
  }
  const intensities = (): Promise<unknown[]> =>
    page.evaluate(() =>
      window.editor.document.scene
        .componentsOf<Light>('Light')
        .filter(({ type }) => type === 'point')
        .map(({ intensity }) => intensity),
    );
  const light = page.getByRole('region', { name: 'Light', exact: true });
  const type = async (value: string): Promise<void> => {
    await inspectorFollows(page);
    await light.getByLabel('Intensity', { exact: true }).fill(value);
    await page.keyboard.press('Enter');
  };

  // the third has its own value; the second one's becomes the prefab's
  await type('3');
  const mark = light.getByRole('button', { name: 'Intensity differs from the prefab' });
  await expect(mark).toBeVisible();
  expect(await axeProblems(page)).toEqual([]);
  await page.getByRole('treeitem', { name: 'Point light' }).nth(1).click();
  await inspectorFollows(page);
  await expect(mark).toHaveCount(0);
  await type('50');
  await mark.click();
  await page.getByRole('menuitem', { name: 'Apply to prefab' }).click();
  expect(await intensities()).toEqual([50, 50, 3]);
  await expect(mark).toHaveCount(0);
  await page.keyboard.press('Control+z');
  expect(await intensities()).toEqual([12, 50, 3]);
  await page.keyboard.press('Control+Shift+z');

  await page.getByRole('treeitem', { name: 'Point light' }).nth(2).click();
  await expect(page.getByRole('group', { name: 'Prefab' })).toContainText('1 override');
  await mark.click();
  await expect(page.getByRole('menuitem', { name: 'Revert to prefab' })).toContainText('The prefab has 50.');
  await page.getByRole('menuitem', { name: 'Revert to prefab' }).click();
  expect(await intensities()).toEqual([50, 50, 50]);
  expect((await history(page)).at(-1)).toBe('Reverted intensity of Point light 3 to its prefab');

  // renamed
  await page.locator('.asset-card').first().click();
  await page.keyboard.press('F2');
  await page.getByLabel('Name of the prefab').fill('Lamp');
  await page.keyboard.press('Enter');
  await expect(page.locator('.asset-card')).toHaveText('Lamp');
  await page.getByRole('treeitem', { name: 'Point light' }).nth(2).click();
  await expect(page.getByRole('group', { name: 'Prefab' })).toContainText('Lamp');
  await page.keyboard.press('Control+z');
  await expect(page.locator('.asset-card')).toHaveText('Point light');
});

test('a second save goes to the same file, through its handle; a failed one leaves the scene unsaved', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const writes: string[] = [];
    const handle = {
      name: 'kept.json',
      getFile: async () => new File(writes.slice(-1), 'kept.json'),
      createWritable: async () => {
        const failure = Reflect.get(window, 'failure') as [string, string] | undefined;
        if (failure?.[1] === 'Error') throw new Error(failure[0]);
        if (failure) throw new DOMException(...failure);
        let text = '';
        return new WritableStream<Uint8Array>({
          write: (chunk) => void (text += new TextDecoder().decode(chunk)),
          close: () => void writes.push(text),
        });
      },
    };
    Object.assign(window, { writes, asked: 0 });
    Object.assign(window, {
      showOpenFilePicker: async () => [handle],
      showSaveFilePicker: async () => {
        Reflect.set(window, 'asked', (Reflect.get(window, 'asked') as number) + 1);
        return handle;
      },
    });
  });
  await page.goto('./?scene=empty');
  await waitUntilReady(page);
  const writes = (): Promise<string[]> => page.evaluate(() => Reflect.get(window, 'writes') as string[]);
  for (const [count, mesh] of ['Torus', 'Cone'].entries()) {
    await addObject(page, 'Mesh', mesh);
    await page.keyboard.press('Control+s');
    await expect.poll(async () => (await writes()).length).toBeGreaterThan(count);
    await expect.poll(() => page.evaluate(() => window.editor.commands.isDirty)).toBe(false);
    expect((await writes()).at(-1)).toBe(await serialized(page));
  }
  expect(await page.evaluate(() => Reflect.get(window, 'asked') as number)).toBe(1);

  // each way to fail: why, and what to do, in one sentence that names the file
  await addObject(page, 'Mesh', 'Box');
  const notices = page.locator('.notices');
  for (const [name, message, text] of [
    ['Error', 'The disk is full.', 'the disk is full. Save again, or choose another place.'],
    ['QuotaExceededError', '', 'there is no room left. Free space on the disk, or choose another place.'],
    ['NotAllowedError', 'x', 'the browser may not write there any more. Allow it when the browser asks, or choose'],
    ['AbortError', 'Blocked by Safe Browsing.', 'the browser refused the file. Save again under another name.'],
  ]) {
    await page.evaluate(([name, message]) => Reflect.set(window, 'failure', [message, name]), [name, message]);
    await page.keyboard.press('Control+s');
    await expect(notices).toContainText(`“kept.json” was not saved: ${text}`);
    expect(await page.evaluate(() => window.editor.commands.isDirty)).toBe(true);
  }

  // to turn back from choosing a file is no failure; a save takes away what was said of the last one
  await page.evaluate(() => {
    Reflect.deleteProperty(window, 'failure');
    const choose: unknown = Reflect.get(window, 'showSaveFilePicker');
    Object.assign(window, {
      showSaveFilePicker: async () => {
        Object.assign(window, { showSaveFilePicker: choose, turnedBack: true });
        throw new DOMException('The user aborted a request.', 'AbortError');
      },
    });
  });
  const before = await notices.textContent();
  await page.keyboard.press('Control+Shift+s');
  await page.waitForFunction(() => 'turnedBack' in window);
  await page.keyboard.press('Control+s');
  await expect(notices).toContainText('Saved kept.json');
  expect(before).not.toContain('aborted');
  await expect(notices).not.toContainText('refused the file');
  await expect(notices).not.toContainText('aborted');
});

test('a save over what another tab has saved asks, and loses nothing @verify', async ({ page, context }) => {
  const openShared = async (tab: Page): Promise<void> => {
    await tab.goto('./?scene=empty');
    await waitUntilReady(tab);
    await tab.evaluate(async () => {
      const folder = await navigator.storage.getDirectory();
      const handle = await folder.getFileHandle('shared.json', { create: true });
      const file = await handle.getFile();
      const scene = file.size > 0 ? await file.arrayBuffer() : new TextEncoder().encode(window.editor.serialize());
      const { editor } = window as unknown as {
        editor: { openFileBytes(bytes: Uint8Array, file: object): Promise<boolean> };
      };
      await editor.openFileBytes(new Uint8Array(scene), { name: 'shared.json', handle });
    });
  };
  const text = (): Promise<string> =>
    page.evaluate(async () => {
      const folder = await navigator.storage.getDirectory();
      return (await (await folder.getFileHandle('shared.json')).getFile()).text();
    });
  const saved = (tab: Page): Promise<boolean> => tab.evaluate(() => !window.editor.commands.isDirty);
  await openShared(page);
  await addObject(page, 'Mesh', 'Torus');
  await page.keyboard.press('Control+s');
  // nobody has seen the empty file
  await page.getByRole('button', { name: 'Save over it' }).click();
  await expect.poll(() => saved(page)).toBe(true);
  const other = await context.newPage();
  await openShared(other);
  await addObject(other, 'Mesh', 'Cone');
  await other.keyboard.press('Control+s');
  await expect.poll(() => saved(other)).toBe(true);
  const theirs = await text();
  expect(theirs).toContain('Cone');

  await addObject(page, 'Mesh', 'Box');
  await page.keyboard.press('Control+s');
  const dialog = page.getByRole('dialog', { name: '“shared.json” has changed' });
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  expect(await text()).toBe(theirs);
  expect(await saved(page)).toBe(false);
  // as a tab that was ended left it
  await stored(page);
  await page.reload();
  await waitUntilReady(page);
  await page.getByRole('button', { name: 'Recover' }).click();
  await expect(page.getByRole('treeitem', { name: 'Box' })).toBeVisible();
  await page.keyboard.press('Control+s');
  await dialog.getByRole('button', { name: 'Save over it' }).click();
  await expect.poll(() => saved(page)).toBe(true);
  expect(await text()).toContain('Box');
});

test('a save that ends once another scene is open is not that one’s: it keeps no file of the other @verify', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const writes: string[] = [];
    const handle = (name: string): object => ({
      name,
      getFile: async () => new File([], name),
      createWritable: async () => {
        // a slow disk
        if (name === 'first.farol') await new Promise((resolve) => Reflect.set(window, 'goOn', resolve));
        return new WritableStream({ close: () => void writes.push(name) });
      },
    });
    const names = ['first.farol', 'second.farol'];
    Object.assign(window, { writes, showSaveFilePicker: async () => handle(names.shift()!) });
  });
  await page.goto('./?scene=empty');
  await waitUntilReady(page);
  await addObject(page, 'Mesh', 'Torus');
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => 'goOn' in window);
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New empty scene' }).click();
  await page.getByRole('button', { name: 'Don’t save' }).click();
  await expect(page.getByRole('treeitem', { name: 'Torus' })).toHaveCount(0);
  await addObject(page, 'Mesh', 'Cone');
  await page.evaluate(() => (Reflect.get(window, 'goOn') as () => void)());
  await expect(page.locator('.notices')).toContainText('Saved first.farol');
  expect(await page.evaluate(() => window.editor.commands.isDirty)).toBe(true);
  await page.keyboard.press('Control+s');
  await expect(page.locator('.notices')).toContainText('Saved second.farol');
  expect(await page.evaluate(() => Reflect.get(window, 'writes') as string[])).toEqual(['first.farol', 'second.farol']);
});

test('of two files that are dropped while the first is still read, the second is there, with its own assets @verify', async ({
  page,
}) => {
  await openEditor(page, 'empty');
  const empty = JSON.parse(await serialized(page)) as { objects: { components: object[] }[] };
  const picture = '.viewport-place canvas';
  const sceneOf = (name: string, corner: number): TestFile => {
    const url = `data:application/octet-stream;base64,${Buffer.from(TRIANGLE.replace('1 0 0', `${corner} 0 0`)).toString('base64')}`;
    const scene = structuredClone(empty);
    Object.assign(scene, { name, assets: [{ name: 'same.ply', type: 'mesh', url }] });
    scene.objects[0].components.push({ type: 'ObjectRenderer', version: 1, id: 'own', values: { mesh: 'same.ply' } });
    return { name: `${name}.farol`, bytes: Buffer.from(JSON.stringify(scene)) };
  };
  // the first one is read last
  await page.evaluate((size) => {
    const { arrayBuffer } = Blob.prototype;
    let isFirst = true;
    Blob.prototype.arrayBuffer = async function () {
      const bytes = await arrayBuffer.call(this);
      if (isFirst && this.size === size) {
        isFirst = false;
        await new Promise((resolve) => Reflect.set(window, 'goOn', resolve));
      }
      return bytes;
    };
  }, TRIANGLE.length);
  await dropFiles(page, picture, [sceneOf('First', 1)]);
  await page.waitForFunction(() => 'goOn' in window);
  await dropFiles(page, picture, [sceneOf('Second', 2)]);
  await page.waitForFunction(() => window.editor.document.scene.name === 'Second');
  await expect(page.getByRole('dialog', { name: 'Opening First.farol' })).toBeVisible();
  await page.evaluate(() => (Reflect.get(window, 'goOn') as () => void)());
  await expect(page.getByRole('dialog')).toHaveCount(0);
  expect(
    await page.evaluate(() => {
      const { scene } = window.editor.document;
      return [scene.name, scene.assets.mesh('same.ply').getAttribute('position').getX(1)];
    }),
  ).toEqual(['Second', 2]);
});

test('a page that is left with nothing unsaved offers nothing to recover @verify', async ({ page }) => {
  await openEmpty(page);
  await addObject(page, 'Mesh', 'Torus');
  await stored(page);
  // stored with a change, and left before the next time that it is stored
  await page.keyboard.press('Control+z');
  await page.reload();
  await waitUntilReady(page);
  await page.waitForFunction(() => window.editor.autosave !== null);
  await expect(page.getByRole('dialog')).toHaveCount(0);
});

test('where the code of their pictures cannot be fetched, assets have none, and nothing is wrong @verify', async ({
  page,
  watch,
}) => {
  const code = /\/thumbnails[.-][\w.-]+(\?|$)/;
  await page.route(code, (route) => route.abort());
  const failed = page.waitForEvent('requestfailed', (request) => code.test(request.url()));
  await openEmpty(page);
  await page.getByRole('tab', { name: 'Assets' }).click();
  await failed;
  await expect(page.locator('[data-asset="box"]')).toBeVisible();
  expect(watch.forgive(/Failed to load resource: net::ERR_FAILED/)).toBeGreaterThan(0);
});

test('files and samples are opened, and scenes saved, without a network once the editor is there', async ({
  page,
  context,
}) => {
  await openEmpty(page);
  await page.waitForFunction(() => window.editor.worksOffline);
  await context.setOffline(true);
  const opened = await page.evaluate((ply) => {
    const file = JSON.parse(window.editor.serialize()) as { assets: unknown[]; objects: unknown[] };
    file.assets = [{ name: 'own.ply', type: 'mesh', url: `data:application/octet-stream;base64,${btoa(ply)}` }];
    const place = { type: 'Transform', version: 1, id: 'o:Transform', values: {} };
    const shape = { type: 'ObjectRenderer', version: 1, id: 'o:ObjectRenderer', values: { mesh: 'own.ply' } };
    file.objects.push({ id: 'o', name: 'Own', parent: null, components: [place, shape] });
    return window.editor.openFileBytes(JSON.stringify(file), { name: 'own.farol', handle: null });
  }, TRIANGLE);
  expect(opened).toBe(true);
  await expect(page.getByRole('treeitem', { name: 'Own' })).toBeVisible();
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  expect((await download).suggestedFilename()).toBe('own.farol');
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Samples' }).press('ArrowRight');
  await page.getByRole('menuitem', { name: 'Planes and lights' }).click();
  await expect(page.getByRole('treeitem', { name: 'Planes' })).toBeVisible();
});
