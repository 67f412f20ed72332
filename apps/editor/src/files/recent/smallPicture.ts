import type { EditorApi } from '../../api/EditorApi';
import { shownEye } from '../picture/PictureCanvas';

/** Size of the picture of a scene (pixels). */
const WIDTH = 320;
const HEIGHT = 180;
/** Maximum size of the picture of a scene (bytes). */
const MOST = 20_000;

/**
 * Small picture of the scene as the viewport shows it, without the editor's marks; null when the browser cannot make one, or the
 * viewport is not shown.
 */
export async function smallPicture(editor: EditorApi): Promise<Blob | null> {
  const { viewport, document: edited } = editor;
  const { canvas, picture } = viewport;
  const small = Object.assign(document.createElement('canvas'), { width: WIDTH, height: HEIGHT });
  const context = small.getContext('2d');
  if (!context || !canvas.isConnected || canvas.width === 0 || canvas.height === 0) return null;
  context.imageSmoothingQuality = 'high';
  // the scene is drawn again, since the browser clears the canvas after showing a frame
  const { camera, component } = shownEye(editor);
  picture.follow(edited.scene);
  picture.draw(edited.scene, camera, component);
  const height = Math.min(canvas.height, (canvas.width * HEIGHT) / WIDTH);
  const width = (height * WIDTH) / HEIGHT;
  const [x, y] = [(canvas.width - width) / 2, (canvas.height - height) / 2];
  context.drawImage(canvas, x, y, width, height, 0, 0, WIDTH, HEIGHT);
  viewport.invalidate();
  for (const quality of [0.8, 0.5, 0.2]) {
    const blob = await new Promise<Blob | null>((resolve) => small.toBlob(resolve, 'image/webp', quality));
    if (blob === null || blob.size <= MOST) return blob;
  }
  return null;
}
