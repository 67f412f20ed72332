const salts = new WeakMap<HTMLCanvasElement | OffscreenCanvas, string>();
let isInstalled = false;

/**
 * Has the shaders of a canvas's context compile as if never seen: a comment of its own ends each of them, so that the browser's cache of
 * programs does not serve those of an earlier case or of another competitor. A graphics driver may still keep some.
 */
export function saltShaders(canvas: HTMLCanvasElement): void {
  salts.set(canvas, `\n// ${Math.random().toString(36).slice(2)}\n`);
  if (isInstalled) return;
  isInstalled = true;
  const prototype = WebGL2RenderingContext.prototype;
  const { shaderSource } = prototype;
  prototype.shaderSource = function (this: WebGL2RenderingContext, shader, source) {
    shaderSource.call(this, shader, source + (salts.get(this.canvas) ?? ''));
  };
}
