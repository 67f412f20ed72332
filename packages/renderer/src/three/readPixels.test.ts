import { type WebGLRenderer, WebGLRenderTarget } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { readPixels } from './readPixels';

const TIMEOUT_EXPIRED = 0x911b;
const CONDITION_SATISFIED = 0x911c;
const WAIT_FAILED = 0x911d;

/** A renderer with a fake GPU, controlled by `state`; every read returns 7. */
function fakeRenderer() {
  const canvas = new EventTarget();
  const state = { wait: TIMEOUT_EXPIRED, isLost: false, framebuffer: {} as object | undefined };
  const gl = {
    canvas,
    TIMEOUT_EXPIRED,
    WAIT_FAILED,
    isContextLost: () => state.isLost,
    clientWaitSync: vi.fn<() => number>(() => state.wait),
    getBufferSubData: (_target: number, _offset: number, pixels: Uint8Array) => pixels.fill(7),
    createBuffer: () => ({}),
    fenceSync: vi.fn<() => object>(() => ({})),
    deleteBuffer: vi.fn<() => void>(),
    deleteSync: vi.fn<() => void>(),
    bindBuffer: () => {},
    bufferData: () => {},
    readPixels: () => {},
    flush: () => {},
  };
  const webgl = {
    getContext: () => gl,
    properties: { get: () => ({ __webglFramebuffer: state.framebuffer }) },
    state: { bindFramebuffer: () => {} },
    setRenderTarget: () => {},
    getRenderTarget: () => null,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
  } as unknown as WebGLRenderer;
  return { webgl, gl, canvas, state };
}

const target = new WebGLRenderTarget(1, 1);

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('fills the pixels when the GPU is done, and leaves no object', async () => {
  const { webgl, gl, state } = fakeRenderer();
  const pixels = new Uint8Array(4);
  const read = readPixels(webgl, target, 0, 0, 1, 1, pixels);
  await vi.advanceTimersByTimeAsync(20);
  expect(pixels[0]).toBe(0);
  state.wait = CONDITION_SATISFIED;
  await vi.advanceTimersByTimeAsync(20);
  expect(await read).toBe(true);
  expect([...pixels]).toEqual([7, 7, 7, 7]);
  expect(gl.deleteBuffer).toHaveBeenCalledOnce();
  expect(gl.deleteSync).toHaveBeenCalledOnce();
  expect(vi.getTimerCount()).toBe(0);
});

it('ends with the context: by the event, though the context is back at the next look', async () => {
  const { webgl, gl, canvas } = fakeRenderer();
  const read = readPixels(webgl, target, 0, 0, 1, 1, new Uint8Array(4));
  await vi.advanceTimersByTimeAsync(20);
  gl.clientWaitSync.mockClear();
  canvas.dispatchEvent(new Event('webglcontextlost'));
  expect(await read).toBe(false);
  await vi.advanceTimersByTimeAsync(20);
  expect(gl.clientWaitSync).not.toHaveBeenCalled();
  expect(gl.deleteSync).not.toHaveBeenCalled();
});

it('ends with the context: before the event', async () => {
  const { webgl, gl, state } = fakeRenderer();
  const read = readPixels(webgl, target, 0, 0, 1, 1, new Uint8Array(4));
  state.isLost = true;
  await vi.advanceTimersByTimeAsync(20);
  expect(await read).toBe(false);
  expect(gl.clientWaitSync).not.toHaveBeenCalled();
  expect(await readPixels(webgl, target, 0, 0, 1, 1, new Uint8Array(4))).toBe(false);
  expect(gl.fenceSync).toHaveBeenCalledOnce();
});

it('says why nothing can be read', async () => {
  const { webgl, state } = fakeRenderer();
  state.wait = WAIT_FAILED;
  const read = readPixels(webgl, target, 0, 0, 1, 1, new Uint8Array(4));
  await Promise.all([expect(read).rejects.toThrow('clientWaitSync failed'), vi.advanceTimersByTimeAsync(20)]);
  state.framebuffer = undefined;
  await expect(readPixels(webgl, target, 0, 0, 1, 1, new Uint8Array(4))).rejects.toThrow('draw to it first');
});
