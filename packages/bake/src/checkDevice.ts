import type { WebGLRenderer } from 'three';

/** @throws Error for a device that cannot bake */
export function checkDevice(renderer: WebGLRenderer): void {
  const missing = ['EXT_color_buffer_float', 'EXT_float_blend'].filter((name) => !renderer.extensions.has(name));
  if (missing.length === 0) return;
  throw new Error(`This device cannot bake: its WebGL2 has no ${missing.join(' and no ')}.`);
}
