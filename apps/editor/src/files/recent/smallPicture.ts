import type { Viewport } from '../../viewport/Viewport';

/** Size of the pictures (pixels). */
const WIDTH = 240;
const HEIGHT = 135;

/** The middle of the picture that is shown, small; null where the browser makes none. */
export function smallPicture(viewport: Viewport): Promise<Blob | null> {
  const small = document.createElement('canvas');
  small.width = WIDTH;
  small.height = HEIGHT;
  const context = small.getContext('2d');
  if (!context) return Promise.resolve(null);
  context.imageSmoothingQuality = 'high';
  // what was drawn before may be gone from the canvas
  viewport.renderNow();
  const { canvas } = viewport;
  const height = Math.min(canvas.height, (canvas.width * HEIGHT) / WIDTH);
  const width = (height * WIDTH) / HEIGHT;
  const [x, y] = [(canvas.width - width) / 2, (canvas.height - height) / 2];
  context.drawImage(canvas, x, y, width, height, 0, 0, WIDTH, HEIGHT);
  return new Promise((resolve) => small.toBlob(resolve, 'image/webp', 0.8));
}
