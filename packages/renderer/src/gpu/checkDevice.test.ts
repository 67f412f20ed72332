import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { checkDevice, lacksFloatTargets } from './checkDevice';

it.each([
  ['a WebGPURenderer', { isWebGPURenderer: true, getContext: (): unknown => null }],
  ['a canvas', { getContext: (): unknown => ({}) }],
  ['nothing', undefined],
])('refuses %s in one sentence', (_, given) => {
  expect(() => checkDevice(given as unknown as WebGLRenderer, false)).toThrow(
    'Farol: needs a WebGLRenderer with WebGL 2, not a WebGPURenderer.',
  );
});

it('takes a renderer whose context is of another window', () => {
  const webgl = { isWebGLRenderer: true, getContext: () => ({}) } as unknown as WebGLRenderer;
  expect(() => checkDevice(webgl, false)).not.toThrow();
});

/** A renderer of a device with these extensions. */
const deviceOf = (names: readonly string[], isLost: boolean): WebGLRenderer =>
  ({
    extensions: { has: (name: string) => !isLost && names.includes(name) },
    getContext: () => ({
      isContextLost: () => isLost,
      getExtension: (name: string) => (!isLost && names.includes(name) ? {} : null),
      getParameter: () => (isLost ? null : 4),
    }),
  }) as unknown as WebGLRenderer;

it('judges no device by a context that is lost', () => {
  expect(lacksFloatTargets(deviceOf([], false))).toMatch(/^draws to no float colour buffers/);
  expect(lacksFloatTargets(deviceOf(['EXT_color_buffer_half_float'], false))).toBeNull();
  expect(lacksFloatTargets(deviceOf([], true))).toBeNull();
});
