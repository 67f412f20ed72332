import { DataTexture, FloatType, HalfFloatType, LinearFilter, RGBAFormat, type WebGLRenderer } from 'three';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';

/** Side of each of the two tables (texels). */
const SIZE = 64;

/**
 * Makes one texture, 64 × 128, of three's two tables of linearly transformed cosines, the second above the first, to use one
 * texture unit. 32-bit floats if the device filters them, else half floats, as in three.
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
  // minFilter stays NearestFilter, as in three's own tables
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
