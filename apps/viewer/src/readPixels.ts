import {
  DataUtils,
  FloatType,
  HalfFloatType,
  UnsignedByteType,
  Vector2,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

/** An image in linear light. */
export interface Pixels {
  width: number;
  height: number;
  /** [height, width, 4], linear RGBA, bottom row first. */
  data: Float32Array;
}

/**
 * Draws into a render target of the canvas's size and reads it back: without tone mapping and sRGB encoding, as always
 * in three's render targets. Channels are 32-bit floats, 16-bit if the device cannot blend those, bytes if it cannot
 * render to floats.
 *
 * @param draw - draws one frame to the current render target
 */
export function readPixels(webgl: WebGLRenderer, draw: () => void): Pixels {
  const { x: width, y: height } = webgl.getDrawingBufferSize(new Vector2());
  const { extensions } = webgl;
  const floats = extensions.has('EXT_color_buffer_float');
  const whole = floats && extensions.has('EXT_float_blend');
  const type = whole
    ? FloatType
    : floats || extensions.has('EXT_color_buffer_half_float')
      ? HalfFloatType
      : UnsignedByteType;
  const target = new WebGLRenderTarget(width, height, { type });
  const before = webgl.getRenderTarget();
  try {
    webgl.setRenderTarget(target);
    webgl.clear();
    draw();
    const count = width * height * 4;
    const read = <T extends Float32Array | Uint16Array | Uint8Array>(values: T): T => {
      webgl.readRenderTargetPixels(target, 0, 0, width, height, values);
      return values;
    };
    const data =
      type === FloatType
        ? read(new Float32Array(count))
        : type === HalfFloatType
          ? Float32Array.from(read(new Uint16Array(count)), (half) => DataUtils.fromHalfFloat(half))
          : Float32Array.from(read(new Uint8Array(count)), (byte) => byte / 255);
    return { width, height, data };
  } finally {
    webgl.setRenderTarget(before);
    target.dispose();
  }
}
