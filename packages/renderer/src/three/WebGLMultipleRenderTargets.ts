import { WebGLRenderTarget, type RenderTargetOptions } from 'three';

/**
 * Render target with several colour attachments, with the name and arguments of three.js up to r171, for older code such as the
 * thesis's. New code should use three's `WebGLRenderTarget(width, height, { count })`, its base class.
 * @param width - pixels, at least 1
 * @param height - pixels, at least 1
 * @param count - number of colour attachments, at least 1 and at most the device's MAX_DRAW_BUFFERS (4 everywhere)
 */
export class WebGLMultipleRenderTargets extends WebGLRenderTarget {
  readonly isWebGLMultipleRenderTargets = true;

  constructor(width = 1, height = 1, count = 1, options: RenderTargetOptions = {}) {
    if (!Number.isInteger(count) || count < 1) {
      throw new RangeError(`WebGLMultipleRenderTargets: count is ${count}; give a whole number of at least 1.`);
    }
    super(width, height, { ...options, count });
  }
}
