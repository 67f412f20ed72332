import { expect, type Page } from '@playwright/test';

declare global {
  interface Window {
    /** Left by the script of a page that plays a scene. */
    readonly FarolPlayer: { readonly ready: Promise<void> };
  }
}

/** Bytes that the canvas of a page that plays a scene shows once its picture is as it stays: RGBA of sRGB, top row first. */
export async function playerPicture(page: Page): Promise<Buffer> {
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /./);
  const bytes = await page.evaluate(async () => {
    await window.FarolPlayer.ready;
    // what a canvas shows is kept for the turn of the page in which it is drawn
    await new Promise(requestAnimationFrame);
    const canvas = document.querySelector('canvas')!;
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const context = copy.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const letters: string[] = [];
    for (let i = 0; i < data.length; i += 8192) letters.push(String.fromCharCode(...data.subarray(i, i + 8192)));
    return btoa(letters.join(''));
  });
  return Buffer.from(bytes, 'base64');
}
