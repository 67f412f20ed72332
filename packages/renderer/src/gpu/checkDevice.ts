import type { WebGLRenderer } from 'three';

/**
 * Checks that the device has WebGL 2 and the features that Farol needs.
 * @param floatTargets - whether targets of half float or float colour are drawn to
 * @throws Error that names what is missing and the mend
 */
export function checkDevice(webgl: WebGLRenderer, floatTargets: boolean): void {
  // JavaScript hosts may pass anything; a WebGLRenderer has WebGL 2, in whatever window its canvas is
  if (!(webgl as { isWebGLRenderer?: boolean } | undefined)?.isWebGLRenderer)
    throw new Error('Farol: needs a WebGLRenderer with WebGL 2, not a WebGPURenderer.');
  const lacks = floatTargets ? lacksFloatTargets(webgl) : null;
  if (lacks !== null)
    throw new Error(`Farol: this device ${lacks}; use the technique 'forward-single-pass', which needs none.`);
}

/**
 * Null where half float colour targets can be drawn to, else what "this device" does not do. A context that is lost has no
 * extensions, which says nothing of its device. three keeps the answers until the next loss: cheap enough for each frame.
 */
export function lacksFloatTargets(webgl: WebGLRenderer): string | null {
  const { extensions } = webgl;
  if (extensions.has('EXT_color_buffer_float') || extensions.has('EXT_color_buffer_half_float')) return null;
  if (webgl.getContext().isContextLost()) return null;
  return 'draws to no float colour buffers (EXT_color_buffer_float)';
}

/** Whether colours of 32-bit floats can be drawn to and blended. */
export function blendsFloats(gl: WebGL2RenderingContext): boolean {
  // some devices report float blending without float targets
  return gl.getExtension('EXT_color_buffer_float') !== null && gl.getExtension('EXT_float_blend') !== null;
}

/** Number of colour buffers that can be drawn to at once; at least 4. */
export function drawBuffersOf(gl: WebGL2RenderingContext): number {
  return Math.min(gl.getParameter(gl.MAX_DRAW_BUFFERS) as number, gl.getParameter(gl.MAX_COLOR_ATTACHMENTS) as number);
}
