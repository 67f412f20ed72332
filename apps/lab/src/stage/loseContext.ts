/** Frees a context and its memory. Its listeners are not called, since the loss is intended. */
export function loseContext(gl: WebGL2RenderingContext): void {
  gl.canvas.addEventListener('webglcontextlost', (event) => event.stopImmediatePropagation(), {
    capture: true,
    once: true,
  });
  gl.getExtension('WEBGL_lose_context')?.loseContext();
}
