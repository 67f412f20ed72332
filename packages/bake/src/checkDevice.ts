import type { WebGLRenderer } from 'three';

/** @throws Error for a device that cannot bake, and while the context is lost, which says nothing of the device */
export function checkDevice(renderer: WebGLRenderer): void {
  if (renderer.getContext().isContextLost())
    throw new Error('The bake cannot begin: the WebGL context is lost. Bake again once the picture is back.');
  const missing = ['EXT_color_buffer_float', 'EXT_float_blend'].filter((name) => !renderer.extensions.has(name));
  if (missing.length === 0) return;
  throw new Error(`This device cannot bake: its WebGL2 has no ${missing.join(' and no ')}.`);
}
