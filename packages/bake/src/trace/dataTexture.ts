import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';

/** Texels per row of a table, a power of 2 for bit shifts in shaders. Equals TABLE_SHIFT in tables.glsl. */
const WIDTH = 2048;

/** Makes a table of float quadruples on the GPU. @param data - four numbers per texel */
export function dataTexture(data: Float32Array): DataTexture {
  const height = Math.max(1, Math.ceil(data.length / 4 / WIDTH));
  const whole = new Float32Array(4 * WIDTH * height);
  whole.set(data);
  const texture = new DataTexture(whole, WIDTH, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
