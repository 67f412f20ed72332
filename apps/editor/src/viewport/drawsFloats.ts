import type { WebGLRenderer } from 'three';

/** Whether the device can render to float textures. @param whole - 32-bit rather than 16-bit floats */
export function drawsFloats({ extensions }: WebGLRenderer, whole = false): boolean {
  return extensions.has('EXT_color_buffer_float') || (!whole && extensions.has('EXT_color_buffer_half_float'));
}
