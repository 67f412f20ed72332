import type { Driven } from './driven';

/** The picture of a page's canvas, as an address of a PNG, and how many colours it has. */
export const pictureOf = (driven: Driven): Promise<{ url: string; colours: number }> =>
  driven.evaluate(async () => {
    // what a canvas shows is kept for the turn of the page in which it is drawn
    await new Promise(requestAnimationFrame);
    const canvas = document.querySelector('canvas')!;
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const context = copy.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    return { url: copy.toDataURL(), colours: new Set(new Uint32Array(data.buffer)).size };
  });
