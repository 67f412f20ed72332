import { WebGLRenderTarget, type RenderTargetOptions } from 'three';

/**
 * Several colour attachments of one size, drawn to at once, by the name and arguments that three.js had for them until r171:
 * for code written for those, such as that of the thesis. New code makes three's own `WebGLRenderTarget(width, height,
 * { count })`, which this is.
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
