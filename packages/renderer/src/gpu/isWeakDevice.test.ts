import { afterEach, expect, it, vi } from 'vitest';
import type { WebGLRenderer } from 'three';
import { isWeakDevice } from './isWeakDevice';

const STRONG = { buffers: 8, size: 16_384, precision: 'highp', floats: true, memory: 16, touch: 0, fine: true };

function isWeak(lacks: Partial<typeof STRONG>): boolean {
  const { buffers, size, precision, floats, memory, touch, fine } = { ...STRONG, ...lacks };
  vi.stubGlobal('navigator', { deviceMemory: memory, maxTouchPoints: touch });
  vi.stubGlobal('matchMedia', () => ({ matches: fine }));
  return isWeakDevice({
    capabilities: { maxTextureSize: size, getMaxPrecision: () => precision },
    extensions: { has: () => floats },
    getContext: () => ({ getParameter: () => buffers, isContextLost: () => false }),
  } as unknown as WebGLRenderer);
}

afterEach(() => vi.unstubAllGlobals());

it('a desktop is not weak, nor one with a touch screen and a mouse', () => {
  expect(isWeak({})).toBe(false);
  expect(isWeak({ touch: 10 })).toBe(false);
  expect(isWeak({ buffers: 8, size: 8192, memory: 4 })).toBe(false);
});

it.each<[string, Partial<typeof STRONG>]>([
  ['fewer than 8 colour buffers', { buffers: 4 }],
  ['textures of less than 8,192 texels', { size: 4096 }],
  ['no highp', { precision: 'mediump' }],
  ['no float targets', { floats: false }],
  ['little memory', { memory: 2 }],
  ['a touch screen alone', { touch: 5, fine: false }],
])('a device with %s is weak', (_, lacks) => {
  expect(isWeak(lacks)).toBe(true);
});
