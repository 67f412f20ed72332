import {
  DepthTexture,
  FloatType,
  HalfFloatType,
  RedFormat,
  RGBFormat,
  RGFormat,
  UnsignedInt101111Type,
  UnsignedIntType,
  WebGLRenderTarget,
} from 'three';
import { expect, it, vi } from 'vitest';
import { PassTarget } from './PassTarget';
import { targetBytes } from './targetBytes';

it.each([
  ['colours of 8 bits, depth', {}, 4 + 4],
  ['one channel, no depth', { format: RedFormat, depthBuffer: false }, 1],
  ['two half floats', { format: RGFormat, type: HalfFloatType, depthBuffer: false }, 4],
  ['floats of 11, 11 and 10 bits', { format: RGBFormat, type: UnsignedInt101111Type, depthBuffer: false }, 4],
  ['words', { type: UnsignedIntType, depthBuffer: false }, 16],
  ['three textures', { type: HalfFloatType, count: 3, depthBuffer: false }, 24],
  ['floats, depth and stencil as a texture', { type: FloatType, stencilBuffer: true, depthTexture: depth() }, 16 + 8],
  ['4 samples, and their mean', { type: HalfFloatType, samples: 4 }, 4 * (8 + 4) + 8],
  ['4 samples, and mean and depth as textures', { samples: 4, depthTexture: depth() }, 5 * 8],
])('counts bytes a pixel: %s', (_, options, bytes) => {
  expect(targetBytes(new WebGLRenderTarget(3, 5, options))).toBe(15 * bytes);
});

it('leaves out the depth of another target', () => {
  expect(targetBytes(new WebGLRenderTarget(2, 2, { depthTexture: depth() }), false)).toBe(16);
});

it('is held by a pass: made and sized when asked for, made anew after it was freed', () => {
  const held = new PassTarget({ depthTexture: true });
  expect(held.bytes).toBe(0);
  const first = held.of(4, 2);
  expect(held.of(8, 2)).toBe(first);
  expect(held.bytes).toBe(16 * 8);
  const freed = vi.fn<() => void>();
  first.addEventListener('dispose', freed);
  first.depthTexture!.addEventListener('dispose', freed);
  held.dispose();
  expect(freed).toHaveBeenCalledTimes(2);
  expect(held.current).toBeNull();
  expect(held.of(1, 1)).not.toBe(first);
});

function depth(): DepthTexture {
  return new DepthTexture(1, 1, FloatType);
}
