import {
  FloatType,
  HalfFloatType,
  LinearFilter,
  NearestFilter,
  RedFormat,
  type TextureDataType,
  UnsignedByteType,
  WebGLArrayRenderTarget,
  WebGLRenderTarget,
} from 'three';

const plain = { depthBuffer: false, generateMipmaps: false } as const;
const nearest = { ...plain, minFilter: NearestFilter, magFilter: NearestFilter } as const;
const linear = { ...plain, minFilter: LinearFilter, magFilter: LinearFilter, type: HalfFloatType } as const;

/** Square target without filtering, for shaders that fetch single texels. */
export const texelTarget = (size: number, type: TextureDataType): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type });

/** Two 32-bit float textures for sums of samples. */
export const sumsTarget = (size: number): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type: FloatType, count: 2 });

/** Render target with one byte per texel. */
export const maskTarget = (size: number): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type: UnsignedByteType, format: RedFormat });

/** Target of texel positions (32-bit floats), normals and face normals (half floats). */
export function placeTarget(size: number): WebGLRenderTarget {
  const target = new WebGLRenderTarget(size, size, { ...nearest, type: FloatType, count: 3 });
  target.textures[1].type = target.textures[2].type = HalfFloatType;
  return target;
}

/** Half-float array target with a layer for each lightmap, filtered bilinearly. */
export const layersTarget = (size: number, layers: number): WebGLArrayRenderTarget =>
  new WebGLArrayRenderTarget(size, size, layers, linear);

/** Half-float target that materials use as their `lightMap`. */
export const pictureTarget = (size: number): WebGLRenderTarget => new WebGLRenderTarget(size, size, linear);
