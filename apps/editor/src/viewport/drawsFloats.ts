import type { WebGLRenderer } from 'three';

/** Whether the device draws to colours of half floats, or of whole ones. */
export function drawsFloats({ extensions }: WebGLRenderer, whole = false): boolean {
  return extensions.has('EXT_color_buffer_float') || (!whole && extensions.has('EXT_color_buffer_half_float'));
}
