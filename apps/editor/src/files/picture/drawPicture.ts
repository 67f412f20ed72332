import { t } from '@farol/editing';
import { OrthographicCamera, PerspectiveCamera } from 'three';
import type { EditorApi } from '../../api/EditorApi';
import { PngWriter } from './PngWriter';
import { type Tile, tilesOf } from './tilesOf';

export interface PictureOptions {
  /** Pixels, 1 to 32,768. */
  readonly width: number;
  readonly height: number;
  /** Whether nothing lies behind the objects, in place of the scene's background. */
  readonly isTransparent: boolean;
}

/** Copy of a camera that sees as high as it does, in a picture of another shape. */
function cameraFor(
  camera: PerspectiveCamera | OrthographicCamera,
  aspect: number,
): PerspectiveCamera | OrthographicCamera {
  const copy =
    camera instanceof PerspectiveCamera
      ? new PerspectiveCamera().copy(camera, false)
      : new OrthographicCamera().copy(camera, false);
  copy.matrixAutoUpdate = false;
  copy.matrix.copy(camera.matrixWorld);
  copy.updateMatrixWorld(true);
  if (copy instanceof PerspectiveCamera) copy.aspect = aspect;
  else {
    const middle = (copy.left + copy.right) / 2;
    const half = ((copy.top - copy.bottom) / 2) * aspect;
    copy.left = middle - half;
    copy.right = middle + half;
  }
  return copy;
}

/** Copies the rows of a tile, which WebGL gives from the bottom up, colour multiplied by alpha, into a strip. */
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
 * @param signal - ends the work
 * @throws AbortError when `signal` is aborted; Error when the device is lost
 */
export async function drawPicture(
  { viewport, document }: EditorApi,
  { width, height, isTransparent }: PictureOptions,
  signal: AbortSignal,
): Promise<Blob> {
  const { webgl, picture, farol } = viewport;
  const { scene } = document;
  const gl = webgl.getContext();
  await picture.ready;
  const camera = viewport.lookThrough?.three ?? viewport.cameraOf(viewport.panes.main);
  const component = viewport.lookThrough;
  const ratio = webgl.getPixelRatio();
  const size = { ...viewport.size };
  const clearAlpha = webgl.getClearAlpha();
  const drawTile = (tile: Tile, strip: Uint8Array): void => {
    const { drawn } = tile;
    const eye = cameraFor(camera as PerspectiveCamera, width / height);
    eye.setViewOffset(width, height, drawn.x, drawn.y, drawn.width, drawn.height);
    eye.updateProjectionMatrix();
    webgl.setPixelRatio(1);
    webgl.setSize(drawn.width, drawn.height, false);
    picture.follow(scene);
    farol.budget = null;
    const { background } = scene.three;
    if (isTransparent) {
      scene.three.background = null;
      webgl.setClearAlpha(0);
    }
    // as many frames as smoothing over time takes
    for (let frame = 0; frame < Math.max(1, picture.effects.frames); frame++) picture.draw(scene, eye, component);
    scene.three.background = background;
    webgl.setClearAlpha(clearAlpha);
    if (gl.isContextLost())
      throw new Error(t('The graphics device was lost while the picture was drawn: save it again.'));
    const pixels = new Uint8Array(4 * tile.width * tile.height);
    const bottom = drawn.y + drawn.height - tile.y - tile.height;
    webgl.setRenderTarget(null);
    gl.readPixels(tile.x - drawn.x, bottom, tile.width, tile.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    place(pixels, tile, strip, width);
  };
  const png = new PngWriter(width, height);
  // the canvas has another size until the end
  viewport.loop.stop();
  try {
    for (const tiles of tilesOf(width, height)) {
      const strip = new Uint8Array(4 * width * tiles[0].height);
      for (const tile of tiles) {
        signal.throwIfAborted();
        drawTile(tile, strip);
        // the page answers between tiles
        await new Promise(requestAnimationFrame);
      }
      await png.write(strip);
    }
    return await png.end();
  } finally {
    webgl.setPixelRatio(ratio);
    webgl.setSize(size.width, size.height);
    viewport.loop.start();
    viewport.invalidate();
  }
}
