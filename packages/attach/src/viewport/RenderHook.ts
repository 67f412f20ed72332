import type { FarolRenderer } from '@farol/renderer';
import type { Camera, Object3D, WebGLRenderer } from 'three';

type Render = WebGLRenderer['render'];

const IDLE = 500; // ms

/**
 * Takes the place of one renderer's `render`, to have the scene drawn by Farol and to draw the editor's overlay once the
 * page is done with its frame. The page calls `render` as ever; nested calls, Farol's own among them, go to three.
 */
export class RenderHook {
  /** Draws the scene in place of three's own renderer, when it is there. */
  farol: FarolRenderer | null = null;
  /** Frames that the page has drawn to the canvas. */
  frames = 0;
  private drawnAt = -Infinity;
  private readonly original: Render;
  private readonly hooked: Render;
  private depth = 0;
  private planned = false;
  private attached = true;

  /** @param overlay draws over the finished frame, by the function that it is given */
  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly scene: Object3D,
    private readonly overlay: (render: Render) => void,
  ) {
    this.original = webgl.render;
    this.hooked = (scene, camera) => this.render(scene, camera);
    webgl.render = this.hooked;
  }

  /** Whether the page has drawn nothing for a while: it draws on demand, or not at all. */
  get isIdle(): boolean {
    return performance.now() - this.drawnAt > IDLE;
  }

  /** Gives the renderer its own `render` back. */
  dispose(): void {
    this.attached = false;
    this.farol = null;
    // Another tool may have wrapped ours since: then it stays, and only passes calls on.
    if (this.webgl.render === this.hooked) this.webgl.render = this.original;
  }

  private render(scene: Object3D, camera: Camera): void {
    const { webgl, farol } = this;
    if (!this.attached || this.depth > 0) {
      this.original.call(webgl, scene, camera);
      return;
    }
    this.depth++;
    try {
      if (farol && scene === this.scene && !webgl.xr.isPresenting) farol.render(scene, camera);
      else this.original.call(webgl, scene, camera);
    } finally {
      this.depth--;
    }
    if (webgl.getRenderTarget() === null && !webgl.xr.isPresenting) this.plan();
  }

  /** The overlay follows when the page's code has returned, so after its last draw, and before the browser shows it. */
  private plan(): void {
    if (this.planned) return;
    this.planned = true;
    queueMicrotask(() => {
      this.planned = false;
      if (!this.attached || this.webgl.getContext().isContextLost()) return;
      this.frames++;
      this.drawnAt = performance.now();
      this.depth++;
      try {
        this.overlay(this.original);
      } finally {
        this.depth--;
      }
    });
  }
}
