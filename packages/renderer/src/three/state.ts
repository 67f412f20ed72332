import type { Vector4, WebGLRenderer } from 'three';

// Functions that set GL state through three's WebGLState, whose cache a direct GL call would make wrong.

/** Whether depth is 1 at the near plane and 0 at the far one. */
export function isDepthReversed(webgl: WebGLRenderer): boolean {
  return webgl.state.buffers.depth.getReversed();
}

/** @param rectangle - x, y, width, height of the bound target (pixels) */
export function setViewport(webgl: WebGLRenderer, rectangle: Vector4): void {
  webgl.state.viewport(rectangle);
}

/** Sets the scissor rectangle (pixels) of draws and clears; `testScissor` enables the test. */
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

/** Binds a texture to the unit that three used last; `unbindTexture` makes three bind its own there again. */
export function bindTexture(webgl: WebGLRenderer, point: number, texture: WebGLTexture): void {
  webgl.state.bindTexture(point, texture);
}

export function unbindTexture(webgl: WebGLRenderer): void {
  webgl.state.unbindTexture();
}

/** Enables colour writes, for clears. */
export function unmaskColour(webgl: WebGLRenderer): void {
  webgl.state.buffers.color.setMask(true);
}

/** Enables depth writes, for clears. */
export function unmaskDepth(webgl: WebGLRenderer): void {
  const { depth } = webgl.state.buffers;
  depth.setTest(true);
  depth.setMask(true);
}

/** Enables writes of all stencil bits, for clears. */
export function unmaskStencil(webgl: WebGLRenderer): void {
  webgl.state.buffers.stencil.setMask(255);
}
