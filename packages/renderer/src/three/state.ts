import type { Vector4, WebGLRenderer } from 'three';

// three's WebGLState caches GL state: a direct GL call would leave the cache wrong.

/** Whether depth is 1 at the near plane and 0 at the far one. */
export function isDepthReversed(webgl: WebGLRenderer): boolean {
  return webgl.state.buffers.depth.getReversed();
}

/** @param rectangle - x, y, width, height of the bound target (pixels) */
export function setViewport(webgl: WebGLRenderer, rectangle: Vector4): void {
  webgl.state.viewport(rectangle);
}

/** Cuts draws and clears off outside of a rectangle (pixels); the test is switched on by `testScissor`. */
export function setScissor(webgl: WebGLRenderer, rectangle: Vector4): void {
  webgl.state.scissor(rectangle);
}

export function testScissor(webgl: WebGLRenderer, on: boolean): void {
  webgl.state.setScissorTest(on);
}

/** @param point - FRAMEBUFFER, READ_FRAMEBUFFER or DRAW_FRAMEBUFFER */
export function bindFramebuffer(webgl: WebGLRenderer, point: number, framebuffer: WebGLFramebuffer | null): void {
  webgl.state.bindFramebuffer(point, framebuffer);
}

/** Binds a texture to the unit that three used last; `unbindTexture` has three bind what it needs there. */
export function bindTexture(webgl: WebGLRenderer, point: number, texture: WebGLTexture): void {
  webgl.state.bindTexture(point, texture);
}

export function unbindTexture(webgl: WebGLRenderer): void {
  webgl.state.unbindTexture();
}

/** Lets clears write colours. */
export function unmaskColour(webgl: WebGLRenderer): void {
  webgl.state.buffers.color.setMask(true);
}

/** Lets clears write depths. */
export function unmaskDepth(webgl: WebGLRenderer): void {
  const { depth } = webgl.state.buffers;
  depth.setTest(true);
  depth.setMask(true);
}

/** Lets clears write all bits of the stencil. */
export function unmaskStencil(webgl: WebGLRenderer): void {
  webgl.state.buffers.stencil.setMask(255);
}
