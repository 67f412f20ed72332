import type { Light } from '@farol/engine';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { test as own } from '../support/test';
import { addObject, fieldOf, history, openEditor, serialized } from './editor';
import { dropFiles, pixelAt, plainSky, redBox } from './models';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

const picture = '.viewport-place canvas';

test('imports a glTF by drop, lights it by an HDR, places it again from the panel, deletes it with its uses named', async ({
  page,
}) => {
  await dropFiles(page, picture, [redBox()]);
  await expect(page.getByRole('treeitem', { name: 'box' })).toHaveAttribute('aria-selected', 'true');
  expect(await history(page)).toEqual(['Imported box.glb', 'Added box']);
  expect(await fieldOf(page, 'box', 'ModelRenderer', 'model')).toBe('box.glb');
  await page.locator(picture).focus();
  await page.keyboard.press('f');

  // the sky alone lights it, and is behind it
  await page.evaluate(() =>
    window.editor.document.scene.componentsOf<Light>('Light').forEach((light) => (light.enabled = false)),
  );
  const [darkRed] = await pixelAt(page, 0.5, 0.5);
  await dropFiles(page, picture, [plainSky(1)]);
  await expect.poll(() => history(page)).toContain('Lit the scene by sky.hdr');
  await expect.poll(async () => (await pixelAt(page, 0.5, 0.5))[0]).toBeGreaterThan(darkRed + 60);
  const [red, green, blue] = await pixelAt(page, 0.5, 0.5);
  expect(red).toBeGreaterThan(120);
  expect(Math.max(green, blue)).toBeLessThan(red / 2);
  expect(Math.min(...(await pixelAt(page, 0.03, 0.97)))).toBeGreaterThan(200);

  // the same bytes come once; a second one is placed from the panel
  await page.getByRole('tab', { name: 'Assets' }).click();
  await dropFiles(page, '.assets-body', [redBox('copy.gltf')]);
  await expect(page.locator('[data-asset="box.glb"]')).toBeVisible();
  await expect(page.locator('[data-asset="copy.glb"]')).toHaveCount(0);
  await page.getByLabel('Search assets').fill('box glb');
  await page.locator('[data-asset="box.glb"]').dblclick();
  await expect(page.getByRole('treeitem', { name: 'box' })).toHaveCount(2);
  await expect(page.locator('[data-asset="box.glb"] img')).toBeVisible();

  await page.locator('[data-asset="box.glb"]').click();
  await page.keyboard.press('Delete');
  const dialog = page.getByRole('dialog');
  await expect(dialog).toContainText('It is used in 2 places');
  await expect(dialog).toContainText('box ModelRenderer.model becomes empty.');
  const before = await serialized(page);
  await dialog.getByRole('button', { name: 'Delete' }).click();
  await expect(page.locator('[data-asset="box.glb"]')).toHaveCount(0);
  expect(await fieldOf(page, 'box', 'ModelRenderer', 'model')).toBeNull();
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
});

test('an asset is dragged into the picture, onto an object of the tree, and into a slot of the inspector', async ({
  page,
}) => {
  await page.getByRole('tab', { name: 'Assets' }).click();
  await page.getByLabel('Search assets').fill('torus');
  const torus = page.locator('[data-asset="torus"]');
  await torus.dragTo(page.locator(picture));
  await expect(page.getByRole('treeitem', { name: 'torus' })).toBeVisible();
  await torus.dragTo(page.getByRole('treeitem', { name: 'torus' }));
  await expect(page.getByRole('treeitem', { name: 'torus' })).toHaveCount(2);
  await addObject(page, 'Mesh', 'Box');
  const slot = page.locator('[data-field="mesh"] .asset-slot');
  await torus.dragTo(slot);
  await expect.poll(() => fieldOf(page, 'Box', 'ObjectRenderer', 'mesh')).toBe('torus');
});

test('files that cannot be read are named with the mend, and nothing changes', async ({ page }) => {
  const before = await serialized(page);
  const cut = redBox('cut.gltf');
  const notice = page.locator('.notices');
  await dropFiles(page, picture, [{ name: 'cut.gltf', bytes: cut.bytes.subarray(0, 400) }]);
  await expect(notice).toContainText('cut.gltf cannot be imported: its JSON cannot be read');
  await dropFiles(page, picture, [{ name: 'photo.png', bytes: Buffer.from('hello') }]);
  await expect(notice).toContainText('photo.png cannot be imported: its bytes are not PNG, JPEG or WebP');
  await dropFiles(page, picture, [{ name: 'film.mp4', bytes: Buffer.from('hello') }]);
  await expect(notice).toContainText('film.mp4 cannot be imported: only .glb, .gltf');
  await dropFiles(page, picture, [{ name: 'scene.farol', bytes: Buffer.from('PK\u0003\u0004cut') }]);
  await expect(page.getByRole('dialog')).toContainText('The file is cut short or damaged');
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  const newer = JSON.stringify({ ...JSON.parse(before), version: 99 });
  await dropFiles(page, picture, [{ name: 'newer.json', bytes: Buffer.from(newer) }]);
  await expect(page.getByRole('dialog')).toContainText('version is 99, but this Farol reads files up to version 3');
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  expect(await serialized(page)).toBe(before);
});

own(
  'a model that takes long can be cancelled, and leaves all as it was; one of 2 million vertices leaves the page its turns @verify',
  async ({ page }) => {
    await openEditor(page, 'empty');
    const state = (): Promise<unknown> =>
      page.evaluate(() => [
        window.editor.serialize(),
        window.editor.document.scene.assets.list(),
        window.editor.commands.history,
      ]);
    const before = await state();
    await page.evaluate(() => {
      const { arrayBuffer } = Blob.prototype;
      Blob.prototype.arrayBuffer = () => new Promise(() => {});
      Reflect.set(window, 'readOn', () => (Blob.prototype.arrayBuffer = arrayBuffer));
    });
    const box = redBox('box.gltf');
    await dropFiles(page, picture, [{ name: 'box.glb', bytes: box.bytes }]);
    const dialog = page.getByRole('dialog', { name: 'Reading box.glb' });
    await expect(dialog).toBeVisible();
    expect(await axeProblems(page)).toEqual([]);
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await expect(dialog).toHaveCount(0);
    expect(await state()).toEqual(before);
    await expect(page.locator('.notice')).toHaveCount(0);

    const turns = await page.evaluate(async () => {
      (Reflect.get(window, 'readOn') as () => void)();
      const count = 2_000_000;
      const json = JSON.stringify({
        asset: { version: '2.0' },
        scene: 0,
        scenes: [{ nodes: [0] }],
        nodes: [{ mesh: 0, name: 'Dust' }],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 0 }] }],
        accessors: [{ bufferView: 0, componentType: 5126, count, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1] }],
        bufferViews: [{ buffer: 0, byteLength: count * 12 }],
        buffers: [{ byteLength: count * 12 }],
      }).padEnd(512);
      const head = new Uint32Array([0x46546c67, 2, 28 + json.length + count * 12, json.length, 0x4e4f534a]);
      const positions = new Float32Array(count * 3);
      for (let i = 0; i < positions.length; i++) positions[i] = (i % 997) / 997;
      const file = new File([head, json, new Uint32Array([count * 12, 0x004e4942]), positions], 'dust.glb');
      // a clock that goes on by 1 ms each time that it is looked at
      let now = 1e6;
      performance.now = () => now++;
      const { scheduler } = window as unknown as { scheduler: { yield(): Promise<void> } };
      const giveTurn = scheduler.yield.bind(scheduler);
      let turns = 0;
      scheduler.yield = () => (turns++, giveTurn());
      const { assets } = window.editor.document.scene;
      assets.registerFile('dust.glb', file);
      await assets.load('dust.glb');
      return turns;
    });
    // 123 looks at the clock, a turn at each 20th
    expect(turns).toBeGreaterThanOrEqual(5);
  },
);
