/** Gives a context and its memory back. Nobody is told of the loss: it is meant. */
export function loseContext(gl: WebGL2RenderingContext): void {
  gl.canvas.addEventListener('webglcontextlost', (event) => event.stopImmediatePropagation(), {
    capture: true,
    once: true,
  });
  gl.getExtension('WEBGL_lose_context')?.loseContext();
}
