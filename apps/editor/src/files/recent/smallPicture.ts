import type { Viewport } from '../../viewport/Viewport';

/** Size of thumbnails (pixels). */
const WIDTH = 240;
const HEIGHT = 135;

/** Thumbnail of the centre of the viewport; null when the browser cannot make one. */
export function smallPicture(viewport: Viewport): Promise<Blob | null> {
  const small = document.createElement('canvas');
  small.width = WIDTH;
  small.height = HEIGHT;
  const context = small.getContext('2d');
  if (!context) return Promise.resolve(null);
  context.imageSmoothingQuality = 'high';
  // a canvas is cleared after its frame was shown
  viewport.renderNow();
  const { canvas } = viewport;
  const height = Math.min(canvas.height, (canvas.width * HEIGHT) / WIDTH);
  const width = (height * WIDTH) / HEIGHT;
  const [x, y] = [(canvas.width - width) / 2, (canvas.height - height) / 2];
  context.drawImage(canvas, x, y, width, height, 0, 0, WIDTH, HEIGHT);
  return new Promise((resolve) => small.toBlob(resolve, 'image/webp', 0.8));
}
