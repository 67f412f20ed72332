/** Widest picture that is compared (pixels). */
const WIDEST = 320;

/**
 * A picture, as it would be shown on black: 8-bit sRGB, RGBA.
 *
 * @param widest - greatest width of the result (pixels); default that of pictures which are compared
 */
export function readPicture(source: HTMLCanvasElement | ImageData, widest = WIDEST): ImageData {
  const width = Math.min(widest, source.width);
  const height = Math.max(1, Math.round((source.height * width) / source.width));
  const context = context2D(width, height);
  context.imageSmoothingQuality = 'high';
  context.drawImage(source instanceof ImageData ? canvasOf(source) : source, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

function canvasOf(pixels: ImageData): HTMLCanvasElement {
  const context = context2D(pixels.width, pixels.height);
  context.putImageData(pixels, 0, 0);
  return context.canvas;
}

function context2D(width: number, height: number): CanvasRenderingContext2D {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true });
  if (!context) throw new Error('The picture cannot be read: the browser gives no 2D canvas. Close some tabs.');
  return context;
}
