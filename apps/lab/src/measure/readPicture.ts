/** Widest picture that is compared (pixels). */
const WIDEST = 320;

/** The picture on a canvas, as it would be shown on black: 8-bit sRGB, `WIDEST` pixels wide at most. */
export function readPicture(canvas: HTMLCanvasElement): ImageData {
  const width = Math.min(WIDEST, canvas.width);
  const height = Math.max(1, Math.round((canvas.height * width) / canvas.width));
  const small = document.createElement('canvas');
  Object.assign(small, { width, height });
  const context = small.getContext('2d', { alpha: false, willReadFrequently: true });
  if (!context) throw new Error('The picture cannot be read: the browser gives no 2D canvas. Close some tabs.');
  context.imageSmoothingQuality = 'high';
  context.drawImage(canvas, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}
