import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import { expect } from '@playwright/test';

const libraries = createRequire(new URL('../../apps/editor/package.json', import.meta.url));

/** Seconds in which the marker crosses the picture. */
type Seconds = number;

const component = (type: string, id: string, values: object): object => ({ type, version: 1, id, values });

const object = (name: string, place: object, ...components: object[]): object => ({
  ...{ id: name, name, parent: null },
  components: [component('Transform', `${name}-0`, place), ...components],
});

const mesh = (name: string, values: object): object =>
  component('ObjectRenderer', `${name}-1`, { mesh: 'box', castShadow: true, receiveShadow: true, ...values });

/**
 * A scene that moves by physics (boxes fall on a floor), and by a clip that takes a green marker across the top of the picture.
 * @param seconds - that the marker takes
 */
export function movingScene(seconds: Seconds): string {
  const keys = [
    { time: 0, value: [-3, 2.2, 0] },
    { time: seconds, value: [3, 2.2, 0] },
  ];
  const data = JSON.stringify({ tracks: [{ path: '', component: 'Transform', field: 'position', keys }], events: [] });
  const boxes = [0, 1, 2].map((i) =>
    object(
      `box${i}`,
      { position: [i - 1, 1.2 + i * 0.3, -0.5], rotation: [0.3 * i, 0.4, 0.1], scale: [0.6, 0.6, 0.6] },
      mesh(`box${i}`, { colour: [0.8, 0.3 + 0.2 * i, 0.2] }),
      component('Collider', `box${i}-2`, {}),
      component('RigidBody', `box${i}-3`, {}),
    ),
  );
  return JSON.stringify({
    ...{ format: 'farol-scene', version: 3, name: 'Film', activeCamera: 'camera' },
    settings: { background: 'colour', antialiasing: 'none', toneMapping: 'none' },
    assets: [{ name: 'Crosses', type: 'clip', values: { data, duration: seconds } }],
    objects: [
      object('camera', { position: [0, 1, 6] }, component('Camera', 'camera-1', { fov: 0.9 })),
      object('sun', { rotation: [-1, 0.5, 0] }, component('Light', 'sun-1', { type: 'directional', intensity: 2 })),
      object(
        'floor',
        { position: [0, -0.6, 0], scale: [12, 0.2, 12] },
        mesh('floor', {}),
        component('Collider', 'f-2', {}),
      ),
      object(
        'marker',
        // flat and aslant: edges that cross pixels at many places tell its middle to a fraction of a pixel
        { position: [-3, 2.2, 0], rotation: [0, 0, 0.3], scale: [0.3, 0.5, 0.001] },
        mesh('marker', { colour: [0, 0, 0], emissive: [0, 1, 0] }),
        component('Animation', 'marker-2', { clip: 'Crosses', wrap: 'once' }),
      ),
      ...boxes,
    ],
  });
}

export interface FilmSettings {
  readonly width: number;
  readonly height: number;
  readonly to: number;
  readonly rate: string;
  readonly format?: string;
  readonly camera?: string;
  /** Mbit/s. */
  readonly bitrate?: number;
}

/** Fills the dialog in. */
export async function chooseFilm(page: Page, settings: FilmSettings): Promise<void> {
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Save a film…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Save a film' });
  const number = async (label: string, value: number): Promise<void> => {
    await dialog.getByLabel(label, { exact: true }).fill(String(value));
    await dialog.getByLabel(label, { exact: true }).press('Enter');
  };
  const choose = async (label: string, option: string): Promise<void> => {
    await dialog.getByRole('combobox', { name: label }).click();
    await page.getByRole('option', { name: option, exact: true }).click();
  };
  await number('Width', settings.width);
  await number('Height', settings.height);
  await number('To', settings.to);
  await choose('Frames a second', settings.rate);
  if (settings.format) await choose('Format', settings.format);
  if (settings.camera) await choose('Camera', settings.camera);
  if (settings.bitrate) await number('Bitrate', settings.bitrate);
}

/** Makes the film that the dialog shows. @returns the file */
export async function makeFilm(page: Page, patience?: number): Promise<Buffer> {
  const download = page.waitForEvent('download', { timeout: patience });
  await page.getByRole('dialog', { name: 'Save a film' }).getByRole('button', { name: 'Save', exact: true }).click();
  return readFileSync(await (await download).path());
}

/** Frames of a film in the page, as `window.films`, and what decodes them. */
declare global {
  interface Window {
    Mediabunny: typeof import('mediabunny');
    /** RGBA of each decoded frame, by the film's name. */
    films: Record<string, Uint8ClampedArray[]>;
  }
}

/**
 * Decodes every frame of a film, in the page.
 * @param kept - frames whose pixels the page keeps; all when absent
 * @returns their times (s) and the marker's place in each (pixels)
 */
export async function decode(
  page: Page,
  film: Buffer,
  name: string,
  kept?: readonly number[],
): Promise<{ times: number[]; markers: number[]; size: [number, number] }> {
  if (!(await page.evaluate(() => 'Mediabunny' in window))) {
    const path = libraries.resolve('mediabunny').replace('.node.cjs', '.min.cjs');
    // a copy of its own beside the editor's, which only writes
    await page.evaluate(`delete globalThis[Symbol.for('mediabunny loaded')]; ${readFileSync(path, 'utf8')};
      window.Mediabunny = Mediabunny; 0`);
  }
  return page.evaluate(
    async ([base64, key, indices]) => {
      const { ALL_FORMATS, BufferSource, Input, VideoSampleSink } = window.Mediabunny;
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const input = new Input({ source: new BufferSource(bytes), formats: ALL_FORMATS });
      const track = (await input.getPrimaryVideoTrack())!;
      const times: number[] = [];
      const markers: number[] = [];
      const frames: Uint8ClampedArray[] = [];
      let size: [number, number] = [0, 0];
      let context: OffscreenCanvasRenderingContext2D | null = null;
      for await (const sample of new VideoSampleSink(track).samples()) {
        size = [sample.displayWidth, sample.displayHeight];
        context ??= new OffscreenCanvas(...size).getContext('2d', { willReadFrequently: true })!;
        sample.draw(context, 0, 0);
        times.push(sample.timestamp);
        sample.close();
        const { data } = context.getImageData(0, 0, ...size);
        let sum = 0;
        let count = 0;
        for (let i = 0; i < data.length; i += 4) {
          if (data[i + 1] < 120 || data[i] > 90 || data[i + 2] > 90) continue;
          sum += (i / 4) % size[0];
          count++;
        }
        markers.push(sum / count);
        if (!indices || indices.includes(times.length - 1)) frames[times.length - 1] = data;
      }
      (window.films ??= {})[key] = frames;
      return { times, markers, size };
    },
    [film.toString('base64'), name, kept] as const,
  );
}

/** Saves what is seen now by the dialog of pictures. @returns the PNG */
export async function saveStill(page: Page, width: number, height: number): Promise<Buffer> {
  await page.evaluate(() => void window.editor.dialogs.show({ kind: 'picture' } as never));
  const dialog = page.getByRole('dialog', { name: 'Save a picture' });
  for (const [label, value] of Object.entries({ Width: width, Height: height })) {
    await dialog.getByLabel(label, { exact: true }).fill(String(value));
    await dialog.getByLabel(label, { exact: true }).press('Enter');
  }
  const download = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save' }).click();
  const png = readFileSync(await (await download).path());
  await expect(page.getByRole('dialog')).toHaveCount(0);
  return png;
}

/** Peak signal-to-noise ratio (dB) of a decoded frame against a PNG; Infinity for equal ones. */
export const psnr = (page: Page, name: string, frame: number, png: Buffer): Promise<number> =>
  page.evaluate(
    async ([key, index, base64]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      const still = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
      const shown = window.films[key][index];
      if (shown.length !== still.length) throw new RangeError('The frame has another size than the still.');
      let squares = 0;
      for (let i = 0; i < still.length; i++) if (i % 4 < 3) squares += (still[i] - shown[i]) ** 2;
      return 10 * Math.log10(255 ** 2 / (squares / ((still.length * 3) / 4)));
    },
    [name, frame, png.toString('base64')] as const,
  );
