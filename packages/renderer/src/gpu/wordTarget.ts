import {
  NearestFilter,
  type PixelFormat,
  type PixelFormatGPU,
  RGBAIntegerFormat,
  type TextureDataType,
  UnsignedIntType,
  WebGLRenderTarget,
} from 'three';

/** Makes a target of unsigned integers, by default four words of 32 bits a texel; initially 1 × 1 texels. */
export function wordTarget(
  format: PixelFormat = RGBAIntegerFormat,
  type: TextureDataType = UnsignedIntType,
  internalFormat: PixelFormatGPU = 'RGBA32UI',
): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    format,
    type,
    internalFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
}
