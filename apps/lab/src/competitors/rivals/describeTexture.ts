import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearMipmapNearestFilter,
  MirroredRepeatWrapping,
  NearestFilter,
  NearestMipmapLinearFilter,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
  type Texture,
  UnsignedByteType,
} from 'three';
import type { RivalTexture, RivalWrap } from './RivalScene';

const wraps = new Map<number, RivalWrap>([
  [RepeatWrapping, 'repeat'],
  [MirroredRepeatWrapping, 'mirror'],
  [ClampToEdgeWrapping, 'clamp'],
]);

interface TexelImage {
  readonly data: Uint8Array | Uint8ClampedArray;
  readonly width: number;
  readonly height: number;
}

const hasTexels = (image: unknown): image is TexelImage =>
  typeof image === 'object' &&
  image !== null &&
  'data' in image &&
  (image.data instanceof Uint8Array || image.data instanceof Uint8ClampedArray);

/** Texels of a picture decoded by the browser. The canvas premultiplies alpha: transparent texels lose bits. */
function readPicture(image: TexImageSource, name: string): TexelImage {
  const { width, height } = image as { width: number; height: number };
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error(`Texture ${name}: the browser has no 2D canvas left to read it with. Close some tabs.`);
  context.drawImage(image as CanvasImageSource, 0, 0);
  return context.getImageData(0, 0, width, height);
}

function flipRows(data: Uint8Array, width: number, height: number): Uint8Array {
  const flipped = new Uint8Array(data.length);
  const row = width * 4;
  for (let y = 0; y < height; y++) flipped.set(data.subarray(y * row, (y + 1) * row), (height - 1 - y) * row);
  return flipped;
}

/**
 * Converts three's texture to the texels that three would upload.
 * @throws Error for compressed, floating-point and other textures that are not 8-bit RGBA
 */
export function describeTexture(texture: Texture): RivalTexture {
  const name = texture.name || 'without a name';
  const { image, format, type } = texture as { image: unknown; format: number; type: number };
  const isPlain = format === RGBAFormat && type === UnsignedByteType && !('isCompressedTexture' in texture);
  if (!isPlain) throw new Error(`Texture ${name} is not 8-bit RGBA: other engines get only that.`);
  if (image === null || image === undefined) throw new Error(`Texture ${name} has no picture yet: load it first.`);
  const { data, width, height } = hasTexels(image) ? image : readPicture(image as TexImageSource, name);
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  // WebGL does not flip an ImageBitmap
  const isFlipped = texture.flipY && !(typeof ImageBitmap !== 'undefined' && image instanceof ImageBitmap);
  const { minFilter } = texture;
  return {
    width,
    height,
    pixels: isFlipped ? flipRows(bytes, width, height) : bytes,
    isSrgb: texture.colorSpace === SRGBColorSpace,
    wrapU: wraps.get(texture.wrapS) ?? 'clamp',
    wrapV: wraps.get(texture.wrapT) ?? 'clamp',
    isMagLinear: texture.magFilter === LinearFilter,
    mipmaps:
      minFilter === LinearFilter || minFilter === NearestFilter
        ? 'none'
        : minFilter === LinearMipmapLinearFilter || minFilter === NearestMipmapLinearFilter
          ? 'linear'
          : 'nearest',
    isMinLinear:
      minFilter === LinearFilter || minFilter === LinearMipmapLinearFilter || minFilter === LinearMipmapNearestFilter,
    anisotropy: texture.anisotropy,
  };
}
