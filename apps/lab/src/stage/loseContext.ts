/** Frees a context and its memory. Listeners are not called: the loss is intended. */
export function loseContext(gl: WebGL2RenderingContext): void {
  gl.canvas.addEventListener('webglcontextlost', (event) => event.stopImmediatePropagation(), {
    capture: true,
    once: true,
  });
  gl.getExtension('WEBGL_lose_context')?.loseContext();
}
