import type { Camera, Object3D, WebGLRenderer } from 'three';

type Render = WebGLRenderer['render'];

/** Replacement of a renderer's `render`. @param next - the `render` that it replaces */
export type Interceptor = (scene: Object3D, camera: Camera, next: Render) => void;

/** A replacement of a renderer's `render`, as `interceptRender` returns it. */
export interface Interception {
  /** The renderer's own `render`, without any replacement. */
  readonly stock: Render;
  /** Removes the replacement; once all are removed, the renderer has its own `render` again. */
  remove(): void;
}

const chains = new WeakMap<WebGLRenderer, RenderChain>();

/**
 * Replaces `render` of one renderer by a function; the function added last runs first. Nested calls to `render`, by Farol or
 * callbacks of the host, go to three.
 */
export function interceptRender(webgl: WebGLRenderer, interceptor: Interceptor): Interception {
  let chain = chains.get(webgl);
  if (chain === undefined || !chain.isInPlace) chains.set(webgl, (chain = new RenderChain(webgl)));
  return chain.add(interceptor);
}

/** The replacement of `render` of one WebGLRenderer. */
class RenderChain {
  private readonly original: Render;
  private readonly hooked: Render = (scene, camera) => this.render(scene, camera);
  private readonly interceptors: Interceptor[] = [];
  /** `next` functions of the `interceptors`; the last entry runs first. */
  private readonly draws: Render[];
  private depth = 0;

  constructor(private readonly webgl: WebGLRenderer) {
    this.original = webgl.render;
    this.draws = [(scene, camera) => this.original.call(webgl, scene, camera)];
    webgl.render = this.hooked;
  }

  /** Whether calls of `render` arrive here: directly, or (assumed) through another tool's wrapper. */
  get isInPlace(): boolean {
    return this.webgl.render === this.hooked || this.interceptors.length > 0;
  }

  add(interceptor: Interceptor): Interception {
    this.interceptors.push(interceptor);
    this.link();
    return {
      stock: (scene, camera) => this.nested(this.draws[0], scene, camera),
      remove: () => {
        const index = this.interceptors.indexOf(interceptor);
        if (index < 0) return;
        this.interceptors.splice(index, 1);
        this.link();
        // if another tool has wrapped `render` since, this stays in place and only forwards calls
        if (this.interceptors.length === 0 && this.webgl.render === this.hooked) this.webgl.render = this.original;
      },
    };
  }

  private link(): void {
    const { draws } = this;
    draws.length = 1;
    for (const interceptor of this.interceptors) {
      const next = draws[draws.length - 1];
      draws.push((scene, camera) => interceptor(scene, camera, next));
    }
  }

  private render(scene: Object3D, camera: Camera): void {
    this.nested(this.draws[this.depth > 0 ? 0 : this.draws.length - 1], scene, camera);
  }

  private nested(draw: Render, scene: Object3D, camera: Camera): void {
    this.depth++;
    try {
      draw(scene, camera);
    } finally {
      this.depth--;
    }
  }
}
