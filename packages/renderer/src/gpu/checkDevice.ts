import type { WebGLRenderer } from 'three';

/**
 * Checks that the device has WebGL 2 and the features that Farol needs.
 * @param floatTargets - whether half-float or float colour targets are needed
 * @throws Error that names what is missing and the remedy
 */
export function checkDevice(webgl: WebGLRenderer, floatTargets: boolean): void {
  // JavaScript hosts may pass anything; not instanceof, since the canvas may be in another window
  if (!(webgl as { isWebGLRenderer?: boolean } | undefined)?.isWebGLRenderer)
    throw new Error('Farol: needs a WebGLRenderer with WebGL 2, not a WebGPURenderer.');
  const lacks = floatTargets ? lacksFloatTargets(webgl) : null;
  if (lacks !== null)
    throw new Error(`Farol: this device ${lacks}; use the technique 'forward-single-pass', which needs none.`);
}

/**
 * Null if half-float colour targets can be drawn to, else the end of a sentence "this device …". Also null for a lost context,
 * which has no extensions. three caches extensions until the next loss: cheap enough for each frame.
 */
export function lacksFloatTargets(webgl: WebGLRenderer): string | null {
  const { extensions } = webgl;
  if (extensions.has('EXT_color_buffer_float') || extensions.has('EXT_color_buffer_half_float')) return null;
  if (webgl.getContext().isContextLost()) return null;
  return 'draws to no float colour buffers (EXT_color_buffer_float)';
}

/** Whether 32-bit float colour targets can be drawn to and blended. */
export function blendsFloats(gl: WebGL2RenderingContext): boolean {
  // needs both extensions, since some devices report float blending without float targets
  return gl.getExtension('EXT_color_buffer_float') !== null && gl.getExtension('EXT_float_blend') !== null;
}

/** Number of colour buffers that can be drawn to at once; at least 4. */
export function drawBuffersOf(gl: WebGL2RenderingContext): number {
  return Math.min(gl.getParameter(gl.MAX_DRAW_BUFFERS) as number, gl.getParameter(gl.MAX_COLOR_ATTACHMENTS) as number);
}
