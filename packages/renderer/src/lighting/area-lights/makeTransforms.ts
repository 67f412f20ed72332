import { DataTexture, FloatType, HalfFloatType, LinearFilter, RGBAFormat, type WebGLRenderer } from 'three';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';

/** Side of each of the two tables (texels). */
const SIZE = 64;

/**
 * three's two tables of linearly transformed cosines in one texture, 64 × 128, the second above the first: a shader needs
 * one unit for it. In 32-bit floats where the device filters those, else in half floats, as three has them.
 */
export function makeTransforms(webgl: WebGLRenderer): DataTexture {
  const tables = RectAreaLightTexturesLib.init();
  const isFloat = webgl.extensions.has('OES_texture_float_linear');
  const first = (isFloat ? tables.LTC_FLOAT_1 : tables.LTC_HALF_1)!.image.data as Float32Array<ArrayBuffer>;
  const second = (isFloat ? tables.LTC_FLOAT_2 : tables.LTC_HALF_2)!.image.data as Float32Array<ArrayBuffer>;
  const data = isFloat ? new Float32Array(first.length * 2) : new Uint16Array(first.length * 2);
  data.set(first);
  data.set(second, first.length);
  const texture = new DataTexture(data, SIZE, 2 * SIZE, RGBAFormat, isFloat ? FloatType : HalfFloatType);
  // as three's own tables, filtered when magnified alone
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
