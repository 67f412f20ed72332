import type { EditorApi } from '../../api/EditorApi';
import { nextTask } from './nextTask';
import { copyEye, PictureCanvas, shownEye } from './PictureCanvas';
import { PngWriter } from './PngWriter';
import { type Tile, tilesOf } from './tilesOf';

export interface PictureOptions {
  /** Pixels, 1 to 32,768. */
  readonly width: number;
  readonly height: number;
  /** Whether the background is transparent, in place of the scene's. */
  readonly isTransparent: boolean;
}

/** Copies a tile into a strip: turns its rows, which WebGL returns from the bottom up, and divides colour by alpha. */
function place(pixels: Uint8Array, { x, width, height }: Tile, strip: Uint8Array, stride: number): void {
  for (let row = 0; row < height; row++) {
    const from = 4 * width * (height - 1 - row);
    const to = 4 * (row * stride + x);
    for (let i = 0; i < 4 * width; i += 4) {
      const alpha = pixels[from + i + 3];
      const factor = alpha === 0 ? 0 : 255 / alpha;
      for (let k = 0; k < 3; k++) strip[to + i + k] = Math.min(255, Math.round(pixels[from + i + k] * factor));
      strip[to + i + 3] = alpha;
    }
  }
}

/**
 * The scene as the viewport's camera sees it, without the editor's marks, as a PNG of any size, drawn tile by tile.
 *
 * @param signal - cancels the picture
 * @throws AbortError when `signal` is aborted; Error when the device is lost
 */
export async function drawPicture(
  editor: EditorApi,
  { width, height, isTransparent }: PictureOptions,
  signal: AbortSignal,
): Promise<Blob> {
  const { viewport } = editor;
  const gl = viewport.webgl.getContext();
  await viewport.picture.ready;
  const { camera, component } = shownEye(editor);
  const canvas = new PictureCanvas(editor, isTransparent);
  const drawTile = async (tile: Tile, strip: Uint8Array): Promise<void> => {
    const { drawn } = tile;
    const eye = copyEye(camera, width / height);
    eye.setViewOffset(width, height, drawn.x, drawn.y, drawn.width, drawn.height);
    eye.updateProjectionMatrix();
    canvas.setSize(drawn.width, drawn.height);
    await canvas.drawComplete(eye, component, signal);
    const pixels = new Uint8Array(4 * tile.width * tile.height);
    const bottom = drawn.y + drawn.height - tile.y - tile.height;
    viewport.webgl.setRenderTarget(null);
    gl.readPixels(tile.x - drawn.x, bottom, tile.width, tile.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    place(pixels, tile, strip, width);
  };
  const png = new PngWriter(width, height);
  try {
    for (const tiles of tilesOf(width, height)) {
      const strip = new Uint8Array(4 * width * tiles[0].height);
      for (const tile of tiles) {
        await drawTile(tile, strip);
        await nextTask();
      }
      await png.write(strip);
    }
    return await png.end();
  } finally {
    canvas.giveBack();
  }
}
