const pixel = new Uint8Array(4);

/** Waits until a context has drawn everything: `gl.finish` does not wait in Chrome, reading a pixel of the canvas does. */
export function waitForPixel(gl: WebGL2RenderingContext): void {
  const framebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const pack = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING) as WebGLBuffer | null;
  if (framebuffer) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  if (pack) gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  if (framebuffer) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
  if (pack) gl.bindBuffer(gl.PIXEL_PACK_BUFFER, pack);
}
