import type { WebGLRenderer } from 'three';

/** Whether the device can render to float textures. @param whole - whether 32-bit floats are meant, not 16-bit ones */
export function drawsFloats({ extensions }: WebGLRenderer, whole = false): boolean {
  return extensions.has('EXT_color_buffer_float') || (!whole && extensions.has('EXT_color_buffer_half_float'));
}
