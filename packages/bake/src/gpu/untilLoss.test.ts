import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { Slices } from './Slices';
import { untilLoss } from './untilLoss';

/** A renderer whose fences never signal, as after a lost and restored context. */
function rendererOf(): WebGLRenderer & { domElement: EventTarget } {
  const gl = {
    fenceSync: () => ({}),
    flush() {},
    isContextLost: () => false,
    clientWaitSync: () => gl.WAIT_FAILED,
    WAIT_FAILED: 1,
    ALREADY_SIGNALED: 2,
    CONDITION_SATISFIED: 3,
  };
  return { domElement: new EventTarget(), getContext: () => gl } as unknown as WebGLRenderer;
}

it('ends with the loss of the context, as with the host’s own signal', () => {
  const renderer = rendererOf();
  const host = new AbortController();
  const one = untilLoss(renderer, host.signal);
  const other = untilLoss(renderer);
  host.abort(new Error('by the host'));
  expect(() => one.signal.throwIfAborted()).toThrow('by the host');
  expect(other.signal.aborted).toBe(false);
  renderer.domElement.dispatchEvent(new Event('webglcontextlost'));
  expect(() => other.signal.throwIfAborted()).toThrow(
    'The bake ended: the WebGL context was lost. Bake again once the picture is back.',
  );
  const late = untilLoss(renderer);
  late.end();
  renderer.domElement.dispatchEvent(new Event('webglcontextlost'));
  expect(late.signal.aborted).toBe(false);
});

it('waits for no fence of a context that was lost and is back', async () => {
  await expect(new Slices(rendererOf(), 12, undefined).wait()).rejects.toThrow('The bake ended');
});
