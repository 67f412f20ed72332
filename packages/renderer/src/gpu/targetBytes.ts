import {
  ByteType,
  HalfFloatType,
  RedFormat,
  RedIntegerFormat,
  RGFormat,
  RGIntegerFormat,
  ShortType,
  UnsignedByteType,
  UnsignedInt101111Type,
  UnsignedShortType,
  type Texture,
  type WebGLRenderTarget,
} from 'three';

const ONE_CHANNEL: readonly number[] = [RedFormat, RedIntegerFormat];
const TWO_CHANNELS: readonly number[] = [RGFormat, RGIntegerFormat];
const ONE_BYTE: readonly number[] = [UnsignedByteType, ByteType];
const TWO_BYTES: readonly number[] = [HalfFloatType, UnsignedShortType, ShortType];

/** Bytes of a texel of a colour texture, by its format and type. */
function texelBytes({ format, type }: Texture): number {
  if (type === UnsignedInt101111Type) return 4;
  const channels = ONE_CHANNEL.includes(format) ? 1 : TWO_CHANNELS.includes(format) ? 2 : 4;
  return channels * (ONE_BYTE.includes(type) ? 1 : TWO_BYTES.includes(type) ? 2 : 4);
}

/** Bytes of a texel of depth: of a depth texture by its type, else four (24 bits); eight for float depth with stencil. */
function depthBytes({ depthTexture, depthBuffer, stencilBuffer }: WebGLRenderTarget): number {
  if (depthTexture !== null) return TWO_BYTES.includes(depthTexture.type) ? 2 : stencilBuffer ? 8 : 4;
  return depthBuffer ? 4 : 0;
}

/**
 * Bytes of a render target on the GPU: its textures and depth, and if multisampled their samples too.
 * @param ownsDepth - false if the depth texture belongs to another target. Default true
 */
export function targetBytes(target: WebGLRenderTarget, ownsDepth = true): number {
  let color = 0;
  for (const texture of target.textures) color += texelBytes(texture);
  const depth = ownsDepth ? depthBytes(target) : 0;
  const resolved = color + (target.samples > 0 && target.depthTexture === null ? 0 : depth);
  return target.width * target.height * (resolved + target.samples * (color + depth));
}
