/** Maximum width of pictures that are compared, and of those kept with a run (pixels); none is enlarged. */
const COMPARED = 320;
const KEPT = 160;

/**
 * Reads a picture over black: 8-bit sRGB, RGBA.
 *
 * @param widest - maximum width of the result (pixels); default `COMPARED`
 */
export function readPicture(source: HTMLCanvasElement | ImageData, widest = COMPARED): ImageData {
  const context = reduced(source, widest);
  return context.getImageData(0, 0, context.canvas.width, context.canvas.height);
}

/** A small picture for runs that are kept, as a data URL: WebP, or PNG if the browser cannot encode WebP. */
export const thumbnailOf = (picture: ImageData): string => reduced(picture, KEPT).canvas.toDataURL('image/webp', 0.8);

function reduced(source: HTMLCanvasElement | ImageData, widest: number): CanvasRenderingContext2D {
  const width = Math.min(widest, source.width);
  const height = Math.max(1, Math.round((source.height * width) / source.width));
  const context = context2D(width, height);
  context.imageSmoothingQuality = 'high';
  // recognised by `data`, since ImageData of an iframe has another class than this page's ImageData
  context.drawImage('data' in source ? canvasOf(source) : source, 0, 0, width, height);
  return context;
}

function canvasOf(pixels: ImageData): HTMLCanvasElement {
  const context = context2D(pixels.width, pixels.height);
  context.putImageData(pixels, 0, 0);
  return context.canvas;
}

function context2D(width: number, height: number): CanvasRenderingContext2D {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true });
  if (!context) throw new Error('The picture cannot be read: the browser has no 2D canvas left. Close some tabs.');
  return context;
}
