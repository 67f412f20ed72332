import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { checkDevice } from './bakeLightmaps';

const deviceOf = (names: readonly string[], isLost: boolean): WebGLRenderer =>
  ({
    extensions: { has: (name: string) => !isLost && names.includes(name) },
    getContext: () => ({ isContextLost: () => isLost }),
  }) as unknown as WebGLRenderer;

it('names what a device lacks, and judges none by a context that is lost', () => {
  expect(() => checkDevice(deviceOf(['EXT_color_buffer_float', 'EXT_float_blend'], false))).not.toThrow();
  expect(() => checkDevice(deviceOf(['EXT_color_buffer_float'], false))).toThrow(/has no EXT_float_blend\./);
  expect(() => checkDevice(deviceOf([], true))).toThrow(/^The bake cannot begin: the WebGL context is lost\./);
});
