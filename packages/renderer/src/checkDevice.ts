import type { WebGLRenderer } from 'three';

/**
 * Checks that the device can do what is asked of it.
 * @param floatTargets whether targets of half float or float colour are drawn to
 * @throws Error that names what is missing and the mend
 */
export function checkDevice(webgl: WebGLRenderer, floatTargets: boolean): void {
  const gl = webgl.getContext();
  if (typeof WebGL2RenderingContext === 'undefined' || !(gl instanceof WebGL2RenderingContext)) {
    throw new Error('Farol: needs WebGL 2; make the WebGLRenderer with a WebGL 2 context, in a browser that has it.');
  }
  if (floatTargets && !hasFloatTargets(webgl)) {
    throw new Error(
      "Farol: this device draws to no float colour buffers (EXT_color_buffer_float); use the technique 'forward-single-pass', which needs none.",
    );
  }
}

/** Whether half float or float colour targets can be drawn to. */
export function hasFloatTargets(webgl: WebGLRenderer): boolean {
  const gl = webgl.getContext();
  return gl.getExtension('EXT_color_buffer_float') !== null || gl.getExtension('EXT_color_buffer_half_float') !== null;
}
