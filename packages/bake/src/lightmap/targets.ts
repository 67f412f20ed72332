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

/** A square target that is read texel by texel. */
export const texelTarget = (size: number, type: TextureDataType): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type });

/** Sums of samples in floats, of two kinds. */
export const sumsTarget = (size: number): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type: FloatType, count: 2 });

/** Render target with one byte per texel. */
export const maskTarget = (size: number): WebGLRenderTarget =>
  new WebGLRenderTarget(size, size, { ...nearest, type: UnsignedByteType, format: RedFormat });

/** Positions in floats, normals and normals of faces in half floats. */
export function placeTarget(size: number): WebGLRenderTarget {
  const target = new WebGLRenderTarget(size, size, { ...nearest, type: FloatType, count: 3 });
  target.textures[1].type = target.textures[2].type = HalfFloatType;
  return target;
}

/** Half floats of each lightmap, filtered. */
export const layersTarget = (size: number, layers: number): WebGLArrayRenderTarget =>
  new WebGLArrayRenderTarget(size, size, layers, linear);

/** Half floats that materials are lit with. */
export const pictureTarget = (size: number): WebGLRenderTarget => new WebGLRenderTarget(size, size, linear);
