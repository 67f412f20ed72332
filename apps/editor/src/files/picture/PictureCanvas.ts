import { t } from '@farol/editing';
import type { Camera as CameraComponent } from '@farol/engine';
import type { TechniqueName } from '@farol/renderer';
import { OrthographicCamera, PerspectiveCamera } from 'three';
import type { EditorApi } from '../../api/EditorApi';
import { nextTask } from './nextTask';

/** Maximum number of redraws for a picture that always requests another frame, as a plugin's effect may. */
const ATTEMPTS = 4;

/** A three camera that pictures are drawn with. */
export type Eye = PerspectiveCamera | OrthographicCamera;

/**
 * Copies a camera for a picture of another aspect ratio, keeping the vertical field of view.
 * @param eye - receives the copy when it is of the same type, so that effects see one camera in all frames
 */
export function copyEye(camera: Eye, aspect: number, eye: Eye | null = null): Eye {
  camera.updateWorldMatrix(true, false);
  const isFlat = camera instanceof OrthographicCamera;
  const copy =
    eye instanceof OrthographicCamera === isFlat && eye ? eye : new (isFlat ? OrthographicCamera : PerspectiveCamera)();
  copy.copy(camera as never, false);
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
  copy.updateProjectionMatrix();
  return copy;
}

/** The camera that the viewport shows the scene through, and its component; null for the editor's own. */
export function shownEye({ viewport }: EditorApi): {
  readonly camera: Eye;
  readonly component: CameraComponent | null;
} {
  const { lookThrough } = viewport;
  return { camera: lookThrough?.three ?? (viewport.cameraOf(viewport.panes.main) as Eye), component: lookThrough };
}

/**
 * The viewport's canvas, used for pictures of the scene without the editor's marks, of any size; the viewport does not
 * draw until `giveBack`.
 */
export class PictureCanvas {
  private readonly before;
  private width = 1;
  private height = 1;

  /** @param isTransparent - whether the background is transparent, in place of the scene's */
  constructor(
    private readonly editor: EditorApi,
    private readonly isTransparent = false,
  ) {
    const { webgl, farol, loop, canvas } = editor.viewport;
    this.before = {
      ...{ ratio: webgl.getPixelRatio(), clearAlpha: webgl.getClearAlpha() },
      ...{ budget: farol.budget, technique: farol.technique, fit: canvas.style.objectFit },
    };
    loop.stop();
    canvas.style.objectFit = 'contain';
  }

  /** Sets the size of the following pictures (pixels). */
  setSize(width: number, height: number): void {
    this.width = width;
    this.height = height;
  }

  /** Fixes the technique to the one that drew last, so that all pictures of a series use the same. */
  keepTechnique(): void {
    const { farol } = this.editor.viewport;
    farol.technique = farol.info.technique as TechniqueName;
  }

  /**
   * Draws the current scene. Effects that accumulate frames begin anew and get as many as a still needs, so that a
   * picture does not depend on earlier ones. The canvas keeps the picture until the task ends.
   * @throws Error when the device is lost
   */
  draw(eye: Eye, component: CameraComponent | null): void {
    const { viewport, document } = this.editor;
    const { webgl, picture } = viewport;
    const { scene } = document;
    this.begin();
    picture.effects.forgetFrames();
    for (let drawn = 0; drawn < Math.max(1, picture.effects.frames); drawn++) this.drawOnce(eye, component);
    if (webgl.getContext().isContextLost())
      throw new Error(t('The graphics device was lost while the picture was drawn: save it again.'));
    // the renderer may have chosen a technique that needs other effects
    picture.effects.update(scene.settings);
  }

  /**
   * Draws as `draw` does, once all files, code and programs are loaded. The canvas keeps the picture until the task
   * ends.
   * @param signal - cancels the wait
   * @throws AbortError when `signal` is aborted; Error when code cannot be fetched, or the device is lost
   */
  async drawComplete(eye: Eye, component: CameraComponent | null, signal: AbortSignal): Promise<void> {
    const { viewport, document } = this.editor;
    const { picture } = viewport;
    for (let left = ATTEMPTS; ; left--) {
      const { assets, settings } = document.scene;
      if (!assets.isSettled) await assets.settled();
      await settings.skyReady;
      signal.throwIfAborted();
      this.draw(eye, component);
      if (picture.isComplete || left === 0) return;
      await this.settle(eye, component, signal);
    }
  }

  /** Gives the canvas back to the viewport. */
  giveBack(): void {
    const { viewport } = this.editor;
    const { webgl, farol, canvas, size } = viewport;
    const { ratio, budget, technique, fit } = this.before;
    farol.budget = budget;
    if (farol.technique !== technique) farol.technique = technique;
    canvas.style.objectFit = fit;
    webgl.setPixelRatio(ratio);
    webgl.setSize(size.width, size.height);
    viewport.loop.start();
    viewport.invalidate();
  }

  /** Draws the frames that the picture requests, until `PictureRenderer.ready` is fulfilled. */
  private async settle(eye: Eye, component: CameraComponent | null, signal: AbortSignal): Promise<void> {
    const { loop, picture } = this.editor.viewport;
    const wait = { isOver: false };
    const ready = picture.ready.finally(() => (wait.isOver = true));
    ready.catch(() => {}); // `await` below reports the error, unless the wait is cancelled before
    while (!wait.isOver) {
      signal.throwIfAborted();
      if (loop.pending > 0) {
        loop.pending--;
        this.begin();
        this.drawOnce(eye, component);
      }
      await nextTask();
    }
    await ready;
  }

  private begin(): void {
    const { viewport, document } = this.editor;
    const { webgl, canvas, picture, farol } = viewport;
    if (canvas.width !== this.width || canvas.height !== this.height) {
      // the window may have been resized since `setSize`
      webgl.setPixelRatio(1);
      webgl.setSize(this.width, this.height, false);
    }
    picture.follow(document.scene);
    farol.budget = null;
  }

  private drawOnce(eye: Eye, component: CameraComponent | null): void {
    const { viewport, document } = this.editor;
    const { webgl, picture } = viewport;
    const { three } = document.scene;
    const { background } = three;
    if (this.isTransparent) {
      three.background = null;
      webgl.setClearAlpha(0);
    }
    webgl.setRenderTarget(null);
    picture.draw(document.scene, eye, component);
    three.background = background;
    webgl.setClearAlpha(this.before.clearAlpha);
  }
}
