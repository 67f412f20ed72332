import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { checkDevice } from './checkDevice';

it.each([
  ['a WebGPURenderer', { isWebGPURenderer: true, getContext: (): unknown => null }],
  ['a canvas', { getContext: (): unknown => ({}) }],
  ['nothing', undefined],
])('refuses %s in one sentence', (_, given) => {
  expect(() => checkDevice(given as unknown as WebGLRenderer, false)).toThrow(
    'Farol: needs a WebGLRenderer with WebGL 2, not a WebGPURenderer.',
  );
});
