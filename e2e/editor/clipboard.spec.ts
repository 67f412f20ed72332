import type { Page } from '@playwright/test';
import { history, serialized, waitUntilReady } from './editor';
import { dropFiles, redBox } from './models';
import { expect, test } from './sharedEditor';

const spin = (rate: number): string => `import { component, number } from '@farol/engine/fields';
export default class Spin extends component({ rate: number(${rate}, { help: 'How fast it turns.' }) }) {}`;

const assetNames = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const { assets } = window.editor.document;
    return assets.list().filter((name) => !assets.isBuiltin(name) && assets.modelOf(name) === null);
  });

const picture = '.viewport-place canvas';

/** Drops a box, and gives it a script, which runs in this browser. */
async function dropSpinning(page: Page): Promise<void> {
  await dropFiles(page, picture, [redBox()]);
  await page.waitForFunction(() => window.editor.document.scene.find('box') !== null);
  await page.evaluate(async (source) => {
    const { assets, scripts, scene } = window.editor.document;
    assets.addFieldAsset('script', 'Spin', { source });
    await scripts.settled();
    scene.find('box')!.addComponent('Spin', { rate: 7 });
  }, spin(1));
  // it has run here: elsewhere in this browser it runs without a question
  await page.waitForFunction(() => localStorage.getItem('farol-known-scripts') !== null);
}

test('what is copied in a tab is pasted in another with its files, materials and scripts', async ({
  page,
  context,
}) => {
  await dropSpinning(page);
  await page.locator(picture).focus();
  await page.keyboard.press('Control+c');
  await page.waitForFunction(() => localStorage.getItem('farol-clipboard') !== null);

  const other = await context.newPage();
  const problems: string[] = [];
  other.on('pageerror', (error) => problems.push(error.message));
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await other.goto('./?scene=empty');
  await waitUntilReady(other);
  await other.locator(picture).focus();
  const empty = await serialized(other);
  await other.keyboard.press('Control+v');
  await expect.poll(() => history(other)).toEqual(['Pasted box']);
  expect(await assetNames(other)).toEqual(['box.glb', 'Spin']);
  await other.waitForFunction(
    () =>
      window.editor.document.scene.find('box')!.getComponent('Spin')?.get('rate') === 7 &&
      window.editor.document.scripts.classOf('Spin') !== null,
  );
  await expect(other.getByRole('alert', { name: 'Scripts are off' })).toBeHidden();
  const once = await serialized(other);
  // nothing is doubled, and one step takes all of it back
  await other.keyboard.press('Control+v');
  await expect.poll(() => history(other)).toEqual(['Pasted box', 'Pasted box']);
  expect(await assetNames(other)).toEqual(['box.glb', 'Spin']);
  await other.keyboard.press('Control+z');
  expect(await serialized(other)).toBe(once);
  await other.keyboard.press('Control+z');
  expect(await serialized(other)).toBe(empty);
  expect(problems).toEqual([]);
  await other.close();
});

test('a script that is pasted and that the user has never run comes switched off @verify', async ({
  page,
  context,
}) => {
  await dropSpinning(page);
  const problems: string[] = [];
  const text = await page.evaluate(() => {
    const { assets, objects, ...file } = JSON.parse(window.editor.serialize()) as {
      assets: { name: string }[];
      objects: { components: { type: string }[] }[];
    };
    const others = objects.map(({ components, ...object }) => ({
      ...object,
      components: components.filter(({ type }) => type !== 'ModelRenderer'),
    }));
    const scripts = assets.filter(({ name }) => name === 'Spin');
    return JSON.stringify({ ...file, assets: scripts, objects: others }).replaceAll('number(1', 'number(2');
  });
  await page.evaluate((file) => void window.editor.openFileBytes(file, { name: 'Other.farol', handle: null }), text);
  await page.getByRole('button', { name: 'Don’t save' }).click();
  await expect(page.getByRole('alert', { name: 'Scripts are off' })).toBeVisible();
  await page.evaluate(() => {
    const { selection, scene } = window.editor.document;
    selection.set([scene.find('box')!.id]);
  });
  await page.locator(picture).focus();
  await page.keyboard.press('Control+c');
  const last = await context.newPage();
  last.on('pageerror', (error) => problems.push(error.message));
  await last.goto('./?scene=empty');
  await waitUntilReady(last);
  await last.waitForFunction(() => localStorage.getItem('farol-clipboard')!.includes('number(2'));
  await last.locator(picture).focus();
  await last.keyboard.press('Control+v');
  const bar = last.getByRole('alert', { name: 'Scripts are off' });
  await expect(bar).toContainText('comes from elsewhere');
  expect(await last.evaluate(() => window.editor.document.scripts.classOf('Spin'))).toBeNull();
  await bar.getByRole('button', { name: 'Run them' }).click();
  await last.waitForFunction(() => window.editor.document.scripts.classOf('Spin') !== null);
  expect(problems).toEqual([]);
  await last.close();
});
