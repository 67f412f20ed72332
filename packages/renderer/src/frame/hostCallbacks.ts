import { type BatchedMesh, Mesh, Object3D, type WebGLRenderer, type WebGLRenderTarget } from 'three';

const { onBeforeRender, onAfterRender } = Object3D.prototype;

type Callback = (...all: never[]) => void;

/** Cache: whether a host's callback draws. */
const drawing = new WeakMap<Callback, boolean>();

/**
 * Whether a callback clears only depth, or draws, in the bound target: its item must then be drawn to the host's target, not to
 * several textures at once. Judged by its source text, until `CallbackWatch` has seen a call do it.
 */
function draws(callback: Callback): boolean {
  let known = drawing.get(callback);
  if (known === undefined)
    drawing.set(
      callback,
      (known = /clear(Depth|\((false|!1))|^(?!.*setRenderTarget).*\.render\(/s.test(String(callback))),
    );
  return known;
}

/** `BatchedMesh.prototype.onBeforeRender`, found from a batch, since importing the class would add 4 kB to every page. */
function callbackOfBatches(batch: Object3D): Callback {
  let prototype: Object3D | null = batch;
  let above: Object3D | null = null;
  while (prototype && (above = Object.getPrototypeOf(prototype) as Object3D | null) !== Mesh.prototype)
    prototype = above;
  return prototype?.onBeforeRender ?? onBeforeRender;
}

/**
 * Whether an object's callbacks may clear depth or draw, by their text or past calls.
 * @param hasPlace - whether the object has a place in the host's order of draws; any callback then counts
 */
export function isStepOfHost(object: Object3D, hasPlace: boolean): boolean {
  const { onBeforeRender: before, onAfterRender: after } = object;
  const isOwn =
    before === onBeforeRender || ((object as BatchedMesh).isBatchedMesh && before === callbackOfBatches(object));
  if (isOwn && after === onAfterRender) return false;
  return hasPlace || draws(before) || draws(after);
}

/** Whether a callback is three's own empty one. */
export function isEmptyCallback(callback: Callback): boolean {
  return callback === onBeforeRender || callback === onAfterRender;
}

/**
 * Watches callbacks of objects while they run: one that clears depth or draws in the bound target, even through another
 * function, counts as drawing from the next frame on.
 */
export class CallbackWatch {
  private callback: Callback | null = null;
  private target: WebGLRenderTarget | null = null;
  /** The WebGLRenderer's `clear`, `render` and the like, or the host's replacements. */
  private clear!: WebGLRenderer['clear'];
  private render!: WebGLRenderer['render'];

  constructor(private readonly webgl: WebGLRenderer) {}

  /** Begins to watch a host's callback. Call `end` after it, even if it throws. */
  begin(callback: Callback): void {
    if (drawing.get(callback) === true) return;
    const { webgl } = this;
    this.callback = callback;
    this.target = webgl.getRenderTarget();
    this.clear = webgl.clear;
    this.render = webgl.render;
    webgl.clear = this.noteClear;
    webgl.render = this.noteRender;
  }

  end(): void {
    if (this.callback === null) return;
    this.callback = null;
    this.webgl.clear = this.clear;
    this.webgl.render = this.render;
  }

  private note(): void {
    if (this.callback !== null && this.webgl.getRenderTarget() === this.target) drawing.set(this.callback, true);
  }

  private readonly noteClear: WebGLRenderer['clear'] = (color = true, depth = true, stencil = true) => {
    if (depth && !color) this.note();
    this.clear.call(this.webgl, color, depth, stencil);
  };

  private readonly noteRender: WebGLRenderer['render'] = (scene, camera) => {
    this.note();
    this.render.call(this.webgl, scene, camera);
  };
}
