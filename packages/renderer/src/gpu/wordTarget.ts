import {
  NearestFilter,
  type PixelFormat,
  type PixelFormatGPU,
  RGBAIntegerFormat,
  type TextureDataType,
  UnsignedIntType,
  WebGLRenderTarget,
} from 'three';

/** A target of whole numbers, four words of 32 bits a texel where nothing else is asked; a texel a side at first. */
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
