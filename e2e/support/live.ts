import type { Page } from '@playwright/test';
import type { FloatImage } from './images';

/** `window` of a page with an example of the site whose clock stands still (`&still`), see apps/site/live/still. */
interface LiveWindow {
  still: {
    run(step: number, frames: number): Promise<void>;
    drawBoth(width: number, height: number): Promise<BothPictures>;
  };
}

interface BothPictures {
  stock: Float32Array;
  farol: Float32Array;
  technique: string;
  leftOut: string[];
}

/** Size of the pictures that are compared (pixels). */
const WIDTH = 192;
const HEIGHT = 108;

/** Opens a live module, standing still, and lets its clock run once all of its code is there. */
export async function openLive(page: Page, name: string, seconds: number, frames: number): Promise<void> {
  await page.goto(`./index.html?${name}&still`);
  await page.waitForFunction(() => 'still' in window);
  await page.evaluate(
    ([step, frames]) => (window as unknown as LiveWindow).still.run(step, frames),
    [seconds / frames, frames],
  );
}

/** Pictures of the open live module by stock three and by its technique, of what both can draw. */
export async function drawLive(
  page: Page,
): Promise<{ stock: FloatImage; farol: FloatImage; technique: string; leftOut: string[] }> {
  const { stock, farol, ...others } = await page.evaluate(
    async ([width, height]) => {
      const { stock, farol, technique, leftOut } = await (window as unknown as LiveWindow).still.drawBoth(
        width,
        height,
      );
      const encode = (pixels: Float32Array): string => {
        const bytes = new Uint8Array(pixels.buffer);
        const parts: string[] = [];
        for (let i = 0; i < bytes.length; i += 8192) parts.push(String.fromCharCode(...bytes.subarray(i, i + 8192)));
        return btoa(parts.join(''));
      };
      return { stock: encode(stock), farol: encode(farol), technique, leftOut: [...leftOut] };
    },
    [WIDTH, HEIGHT],
  );
  return { stock: decode(stock), farol: decode(farol), ...others };
}

function decode(text: string): FloatImage {
  const { buffer, byteOffset, byteLength } = Buffer.from(text, 'base64');
  return { width: WIDTH, height: HEIGHT, data: new Float32Array(buffer.slice(byteOffset, byteOffset + byteLength)) };
}

/** WebP of the page as it stands, without the panels of the example; of at most so many bytes. */
export async function pictureOf(page: Page, mostBytes: number): Promise<Buffer> {
  await page.addStyleTag({ content: '.panel { display: none !important }' });
  const png = (await page.screenshot()).toString('base64');
  for (let quality = 0.86; ; quality -= 0.08) {
    const webp = await page.evaluate(
      async ([png, quality]) => {
        const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob());
        const canvas = document.createElement('canvas');
        canvas.width = bitmap.width;
        canvas.height = bitmap.height;
        canvas.getContext('2d')!.drawImage(bitmap, 0, 0);
        return canvas.toDataURL('image/webp', quality).split(',')[1];
      },
      [png, quality] as const,
    );
    const bytes = Buffer.from(webp, 'base64');
    if (bytes.length <= mostBytes || quality < 0.2) return bytes;
  }
}
