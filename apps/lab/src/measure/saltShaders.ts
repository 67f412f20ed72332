const salts = new WeakMap<HTMLCanvasElement | OffscreenCanvas, string>();
let isInstalled = false;

/**
 * Makes the shaders of a canvas's context compile anew: a random comment at the end of their GLSL prevents hits in the
 * browser's program cache from earlier cases or other competitors. A graphics driver may still reuse programs.
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
