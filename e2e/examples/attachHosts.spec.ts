import type { Page } from '@playwright/test';
import { axeProblems } from '../support/axeProblems';
import { drawExample, openExample } from '../support/example';
import { compareImages } from '../support/images';
import { expect, test } from '../support/test';

async function open(page: Page, name: string): Promise<void> {
  await openExample(page, name);
  await page.setViewportSize({ width: 640, height: 400 });
}

/** The picture, beside the panels. */
const picture = (page: Page) => page.screenshot({ clip: { x: 0, y: 60, width: 320, height: 330 } });
const row = (page: Page, name: string) => page.getByRole('treeitem', { name }).first();
const clockOfR3F = /THREE\.Clock: This module has been deprecated/;

test('on React Three Fiber: what React adds is in the tree, edits are drawn', async ({ page, watch }) => {
  await open(page, 'attach-r3f');
  await expect(row(page, 'ball 1')).toBeVisible();
  await expect(row(page, 'ball 2')).toBeHidden();
  await page.getByRole('button', { name: 'Add a ball' }).click();
  await row(page, 'ball 2').click();
  const before = await picture(page);
  await page.getByRole('spinbutton', { name: 'Scale y' }).fill('2');
  await page.keyboard.press('Enter');
  expect((await picture(page)).equals(before)).toBe(false);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await picture(page)).equals(before)).toBe(true);
  expect(await axeProblems(page)).toEqual([]);
  watch.forgive(clockOfR3F);
});

test('on React Three Fiber beside <Farol>: the editor passes its draw on, or draws by itself @verify', async ({
  page,
  watch,
}) => {
  await openExample(page, 'attach-r3f');
  const stock = await drawExample(page, 'three');
  await page.goto('./examples/attach-r3f/index.html?still&farol');
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
  const seen = async (by: string) => {
    const { psnr } = compareImages(await drawExample(page, by), stock);
    return {
      close: psnr > 55,
      exact: psnr > 80,
      technique: await page.evaluate(() => window.example.farol?.technique),
    };
  };
  // by <Farol technique="deferred">, then by the editor's own forward technique over it
  expect(await seen('three')).toEqual({ close: true, exact: false, technique: undefined });
  expect(await seen('clustered-forward')).toEqual({ close: true, exact: true, technique: 'clustered-forward' });
  expect(await seen('three')).toEqual({ close: true, exact: false, technique: undefined });
  watch.forgive(clockOfR3F);
});

test('dispose leaves the page as it was', async ({ page, pagesURL }) => {
  await page.addInitScript(() => {
    const live = new Map<string, number>();
    (window as unknown as { live: typeof live }).live = live;
    for (const [method, step] of Object.entries({ addEventListener: 1, removeEventListener: -1 })) {
      const original = window[method as 'addEventListener'];
      Object.assign(window, {
        [method](...args: Parameters<typeof original>) {
          const [type, , options] = args;
          live.set(type, (live.get(type) ?? 0) + step);
          const signal = typeof options === 'object' ? options.signal : undefined;
          signal?.addEventListener('abort', () => live.set(type, live.get(type)! - 1));
          original.apply(window, args);
        },
      });
    }
  });
  await page.goto(`${pagesURL}attached.html`);
  await page.waitForFunction(() => 'attachedPage' in window);
  const { before, during, after, pictures } = await page.evaluate(async () => {
    const { webgl, scene, camera, attachEditor, pixels } = window.attachedPage;
    const first = await pixels('three');
    const render = webgl.render;
    const { live } = window as unknown as { live: Map<string, number> };
    const snapshot = () => ({
      render: webgl.render === render,
      // the bundler of this page adds links for code that is fetched late
      elements: document.querySelectorAll(':not(link)').length,
      listeners: [...live]
        .filter(([, count]) => count > 0)
        .sort()
        .join(';'),
      memory: JSON.stringify(webgl.info.memory),
      programs: webgl.info.programs!.length,
      objects: scene.children.map(({ uuid }) => uuid).join(),
      keys: [...Object.keys(webgl), ...Object.keys(scene), ...Object.keys(scene.children[0])].sort().join(),
      style: document.body.getAttribute('style'),
      canvas: webgl.domElement.outerHTML,
      viewport: webgl.getViewport(new window.attachedPage.three.Vector4()).toArray().join(),
      autoClear: webgl.autoClear,
    });
    const before = snapshot();
    const editor = attachEditor(scene, camera, webgl);
    editor.selected = scene.children[0];
    const overlaid = await pixels('three');
    await editor.drawWith('clustered-deferred');
    await pixels('three');
    const during = snapshot();
    editor.dispose();
    editor.dispose(); // a second time does nothing
    const last = await pixels('three');
    const same = (a: number[], b: number[]) => a.every((byte, i) => byte === b[i]);
    return {
      before,
      during,
      after: snapshot(),
      pictures: { overlaid: same(first, overlaid), last: same(first, last) },
    };
  });
  expect(during.render).toBe(false);
  expect(during.memory).not.toBe(before.memory);
  expect(after).toEqual(before);
  expect(pictures).toEqual({ overlaid: false, last: true });
});

test('over a page with its own Farol, or with a composer, and beside another wrapper of render', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}attached.html`);
  await page.waitForFunction(() => 'attachedPage' in window);
  const seen = await page.evaluate(async () => {
    const { webgl, scene, camera, farol, attachEditor, pixels } = window.attachedPage;
    const differs = (a: number[], b: number[]) => a.some((byte, i) => byte !== b[i]);
    const plain = { farol: await pixels('farol'), composer: await pixels('composer') };

    const editor = attachEditor(scene, camera, webgl, { farol });
    editor.selected = scene.children[0];
    const withOwn = differs(plain.farol, await pixels('farol'));
    await editor.drawWith('forward');
    const technique = farol.technique;
    const refused = await editor.drawWith('three').catch((error: Error) => error.message);
    let twice = '';
    try {
      attachEditor(scene, camera, webgl);
    } catch (error) {
      twice = (error as Error).message;
    }
    editor.dispose();

    const overComposer = attachEditor(scene, camera, webgl);
    const untouched = !differs(plain.composer, await pixels('composer')); // nothing selected: no overlay
    overComposer.selected = scene.children[0];
    const withComposer = differs(plain.composer, await pixels('composer'));
    // another tool wraps render, and stays when the editor goes
    const ours = webgl.render;
    let calls = 0;
    webgl.render = (...args) => {
      calls++;
      ours.apply(webgl, args);
    };
    overComposer.dispose();
    const afterwards = !differs(plain.composer, await pixels('composer'));
    return { withOwn, technique, refused, twice, untouched, withComposer, afterwards, called: calls > 0 };
  });
  expect(seen).toEqual({
    ...{ withOwn: true, technique: 'forward', untouched: true, withComposer: true, afterwards: true, called: true },
    refused: expect.stringContaining('its own FarolRenderer'),
    twice: expect.stringContaining('has an editor already'),
  });
});
