import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { Light } from '@farol/engine';
import { byExtent } from '@farol/tools/extent';
import { drop, type Dropped } from '../support/drop';
import { compareImages, isFlat } from '../support/images';
import { test as own } from '../support/test';
import { addressOf, openViewer, readImage, still } from '../support/viewer';
import { expect, test } from './sharedViewer';

/** A square of two triangles as glTF, coloured by a texture if one is named. */
function square(buffer: { uri?: string }, image?: string): object {
  return {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material: 0 }] }],
    materials: [
      {
        doubleSided: true,
        pbrMetallicRoughness: {
          metallicFactor: 0,
          ...(image ? { baseColorTexture: { index: 0 } } : { baseColorFactor: [1, 0.2, 0.1, 1] }),
        },
      },
    ],
    ...(image ? { textures: [{ source: 0 }], images: [{ uri: image }] } : {}),
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [-1, 0, 0], max: [1, 2, 0] },
      { bufferView: 1, componentType: 5126, count: 4, type: 'VEC2' },
      { bufferView: 2, componentType: 5123, count: 6, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 32 },
      { buffer: 0, byteOffset: 80, byteLength: 12 },
    ],
    buffers: [{ byteLength: 92, ...buffer }],
  };
}

function squareBytes(): Uint8Array {
  const floats = new Float32Array([-1, 0, 0, 1, 0, 0, 1, 2, 0, -1, 2, 0, 0, 1, 1, 1, 1, 0, 0, 0]);
  const indices = new Uint16Array([0, 1, 2, 0, 2, 3]);
  return Buffer.concat([new Uint8Array(floats.buffer), new Uint8Array(indices.buffer)]);
}

function glb(): Uint8Array {
  const text = JSON.stringify(square({}));
  const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const body = squareBytes();
  const words = new Uint32Array([0x46546c67, 2, 28 + json.length + body.length, json.length, 0x4e4f534a]);
  const second = new Uint32Array([body.length, 0x004e4942]);
  return Buffer.concat([new Uint8Array(words.buffer), json, new Uint8Array(second.buffer), body]);
}

/** A 2 × 2 PNG of pure blue, made by hand from its chunks. */
const bluePng = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAD0lEQVR42mNgYPgPRmAKABf2A/3HkIu0AAAAAElFTkSuQmCC',
  'base64',
);

/** Mean of a channel in the middle of the picture. */
function middle(image: { width: number; height: number; data: ArrayLike<number> }, channel: number): number {
  let sum = 0;
  let count = 0;
  for (let y = Math.floor(image.height * 0.4); y < image.height * 0.6; y++) {
    for (let x = Math.floor(image.width * 0.45); x < image.width * 0.55; x++) {
      sum += image.data[(y * image.width + x) * 4 + channel];
      count++;
    }
  }
  return sum / count;
}

const shown = (page: Page) => expect.poll(() => page.evaluate(() => window.viewer.modelName));

test('a dropped GLB is shown, framed and lit, by every technique', async ({ page }) => {
  const before = await readImage(page);
  await drop(page, { 'square.glb': glb() });
  await shown(page).toBe('square.glb');
  const techniques = await page.evaluate(() => [...window.viewer.known.techniques]);
  for (const technique of byExtent({ slice: ['forward-single-pass', 'deferred'], verify: techniques })) {
    await page.evaluate((name) => window.viewer.setTechnique(name), technique);
    const image = await readImage(page);
    expect(compareImages(before, image).largest).toBeGreaterThan(0.05);
    expect(isFlat(image)).toBe(false);
    expect(middle(image, 0), `red by ${technique}`).toBeGreaterThan(0.05);
    expect(middle(image, 0)).toBeGreaterThan(2 * middle(image, 2));
  }
});

test('a glTF dropped with its buffer and texture is shown with them', async ({ page }) => {
  await drop(page, {
    'square.gltf': JSON.stringify(square({ uri: 'data/square.bin' }, 'maps/my%20blue.png')),
    'square.bin': squareBytes(),
    'my blue.png': bluePng,
  });
  await shown(page).toBe('square.gltf');
  // an address cannot hold the model, so it names no scene
  const address = await addressOf(page);
  expect(address.scene).toBeUndefined();
  expect(address.technique).toBeDefined();
  const image = await readImage(page);
  expect(middle(image, 2)).toBeGreaterThan(0.05);
  expect(middle(image, 2)).toBeGreaterThan(2 * middle(image, 0));
});

for (const codec of ['draco', 'meshopt', 'ktx2']) {
  test(`a ${codec} GLB is shown`, async ({ page }) => {
    await drop(page, { [`${codec}.glb`]: readFileSync(new URL(`models/${codec}.glb`, import.meta.url)) });
    await shown(page).toBe(`${codec}.glb`);
    const image = await readImage(page);
    expect(isFlat(image)).toBe(false);
    expect(middle(image, 0)).toBeGreaterThan(0.03);
  });
}

test('the number of lights round a model follows the menu, and the camera stays', async ({ page }) => {
  await drop(page, { 'square.glb': glb() });
  await shown(page).toBe('square.glb');
  const points = () =>
    page.evaluate(
      () => window.viewer.engineScene.componentsOf<Light>('Light').filter((l) => l.type === 'point').length,
    );
  const input = page
    .locator('.lil-controller', { hasText: /^lights$/i })
    .locator('input[type=text]')
    .first();
  const pose = () => page.evaluate(() => window.viewer.camera.matrixWorld.toArray());
  await page.evaluate(() => {
    window.viewer.engineScene.activeCamera!.gameObject.transform.position = [0.5, 1.5, 4];
    window.viewer.renderAt(0);
  });
  const before = await pose();
  expect(before.slice(12, 15)).toEqual([0.5, 1.5, 4]);
  for (const count of [5, 9]) {
    await input.fill(`${count}`);
    await input.press('Enter');
    await expect.poll(points).toBe(count);
  }
  (await pose()).forEach((value, i) => expect(value, `element ${i} of the matrix`).toBeCloseTo(before[i], 6));
  expect(await page.evaluate(() => window.viewer.modelName)).toBe('square.glb');
});

const broken: [string, Dropped, RegExp][] = [
  ['a GLB cut short', { 'cut.glb': glb().slice(0, 300) }, /cut\.glb.*cut short.*300/],
  ['a text called .glb', { 'text.glb': 'not a model' }, /text\.glb.*JSON cannot be read/],
  ['a glTF without its buffer', { 'square.gltf': JSON.stringify(square({ uri: 'b.bin' })) }, /square\.gltf.*b\.bin/],
  [
    'a file of another kind',
    { 'notes.txt': 'hello' },
    /there is no \.glb, \.gltf, \.obj, \.stl or \.ply among notes\.txt: choose one/,
  ],
  [
    'a glTF without a mesh',
    { 'empty.gltf': '{"asset":{"version":"2.0"},"scenes":[{}],"scene":0}' },
    /empty\.gltf.*nothing to see/,
  ],
  [
    'a glTF of an absurd count',
    {
      'count.gltf': JSON.stringify(
        square({ uri: `data:application/octet-stream;base64,${Buffer.from(squareBytes()).toString('base64')}` }),
      ).replace(/"count":\d+/, '"count":4000000000'),
    },
    /^count\.gltf: accessor \d has 4,000,000,000 values, more than fit into .*: export it again\./,
  ],
];
for (const [index, [what, files, message]] of broken.entries()) {
  test(`${what} gives a message, and the scene stays${index === 0 ? '' : ' @verify'}`, async ({ page }) => {
    const before = await readImage(page);
    await drop(page, files);
    await expect(page.locator('.message')).toHaveText(message);
    expect(await page.evaluate(() => window.viewer.modelName)).toBeNull();
    expect(compareImages(before, await readImage(page)).largest).toBe(0);
    // The next good file clears the message.
    await drop(page, { 'square.glb': glb() });
    await shown(page).toBe('square.glb');
    await expect(page.locator('.message')).toHaveCount(0);
  });
}

own('a model that takes long says so, and Escape cancels it', async ({ page }) => {
  await openViewer(page, still);
  const before = await readImage(page);
  // it never arrives
  await page.evaluate(() => (Blob.prototype.arrayBuffer = () => new Promise(() => {})));
  await drop(page, { 'square.glb': glb() });
  await expect(page.locator('.message')).toHaveText(/^The model is being read\. Escape cancels\./);
  await page.keyboard.press('Escape');
  await expect(page.locator('.message')).toHaveCount(0);
  expect(compareImages(before, await readImage(page)).largest).toBe(0);
});
