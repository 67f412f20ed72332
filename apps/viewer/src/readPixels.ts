import { DataUtils, FloatType, HalfFloatType, Vector2, type WebGLRenderer, WebGLRenderTarget } from 'three';

/** An image in linear light. */
export interface Pixels {
  width: number;
  height: number;
  /** [height, width, 4], linear RGBA, bottom row first. */
  data: Float32Array;
}

/**
 * Draws into a float target of the canvas's size and reads it back. Tone mapping and the screen's encoding are left out,
 * as three does for any render target. 32 bits a channel, or 16 where the device cannot blend 32.
 *
 * @param draw draws one frame to the current render target
 */
export function readPixels(webgl: WebGLRenderer, draw: () => void): Pixels {
  const { x: width, y: height } = webgl.getDrawingBufferSize(new Vector2());
  const whole = webgl.extensions.has('EXT_color_buffer_float') && webgl.extensions.has('EXT_float_blend');
  const target = new WebGLRenderTarget(width, height, { type: whole ? FloatType : HalfFloatType });
  const before = webgl.getRenderTarget();
  try {
    webgl.setRenderTarget(target);
    webgl.clear();
    draw();
    const data = new Float32Array(width * height * 4);
    if (whole) {
      webgl.readRenderTargetPixels(target, 0, 0, width, height, data);
    } else {
      const halves = new Uint16Array(data.length);
      webgl.readRenderTargetPixels(target, 0, 0, width, height, halves);
      halves.forEach((half, index) => (data[index] = DataUtils.fromHalfFloat(half)));
    }
    return { width, height, data };
  } finally {
    webgl.setRenderTarget(before);
    target.dispose();
  }
}
