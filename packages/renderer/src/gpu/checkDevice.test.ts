import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { checkDevice } from './checkDevice';

it.each([
  ['a WebGPURenderer', { isWebGPURenderer: true, getContext: () => null }],
  ['one that is not initialised', { getContext: () => (null as unknown as { canvas: string }).canvas }],
  ['a canvas', { getContext: () => ({}) }],
  ['nothing', undefined],
])('refuses %s in one sentence', (_, given) => {
  expect(() => checkDevice(given as unknown as WebGLRenderer, false)).toThrow(
    'Farol: needs a WebGLRenderer with WebGL 2, not a WebGPURenderer.',
  );
});
