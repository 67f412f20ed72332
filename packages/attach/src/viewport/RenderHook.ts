import type { FarolRenderer } from '@farol/renderer';
import { type Interception, interceptRender } from '@farol/renderer/intercept';
import { Vector4, type WebGLRenderer } from 'three';
import type { Session } from '../model/Session';

const IDLE = 500; // time without a frame after which the page is idle (ms)

const viewport = new Vector4();

/**
 * Replaces one renderer's `render`, so that Farol can draw the scene, and the editor's overlay is drawn once the page
 * has finished its frame. The page calls `render` as before; nested calls, including Farol's own, go to three.
 */
export class RenderHook {
  /** FarolRenderer that draws the scene in place of three's; null for three's own. */
  farol: FarolRenderer | null = null;
  /** Number of frames that the page has drawn to the canvas. */
  frames = 0;
  private drawnAt = -Infinity;
  private readonly interception: Interception;
  private readonly webgl: WebGLRenderer;
  private planned = false;
  private attached = true;

  /** @param overlay - draws over the finished frame; its `render` is three's original method */
  constructor(
    session: Session,
    private readonly overlay: (render: WebGLRenderer['render']) => void,
  ) {
    const { webgl, scene } = session;
    this.webgl = webgl;
    this.interception = interceptRender(webgl, (drawn, camera, next) => {
      if (drawn === scene && camera === session.camera && webgl.getRenderTarget() === null) {
        const { width, height } = webgl.domElement;
        const ratio = webgl.getPixelRatio();
        session.view.copy(webgl.getViewport(viewport));
        session.view.x *= ratio / width;
        session.view.y *= ratio / height;
        session.view.z *= ratio / width;
        session.view.w *= ratio / height;
      }
      if (this.farol && drawn === scene && !webgl.xr.isPresenting) this.farol.render(drawn, camera);
      else next(drawn, camera);
      if (webgl.getRenderTarget() === null && !webgl.xr.isPresenting) this.plan();
    });
  }

  /** Whether the page has drawn nothing for `IDLE` ms, as a page that draws on demand does. */
  get isIdle(): boolean {
    return performance.now() - this.drawnAt > IDLE;
  }

  /** Restores the renderer's original `render`. */
  dispose(): void {
    this.attached = false;
    this.farol = null;
    this.interception.remove();
  }

  /**
   * Schedules the overlay after the page's code has returned: after the last draw of its frame, and before the browser
   * displays it.
   */
  private plan(): void {
    if (this.planned) return;
    this.planned = true;
    queueMicrotask(() => {
      this.planned = false;
      if (!this.attached || this.webgl.getContext().isContextLost()) return;
      this.frames++;
      this.drawnAt = performance.now();
      this.overlay(this.interception.stock);
    });
  }
}
