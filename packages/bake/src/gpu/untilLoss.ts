import type { WebGLRenderer } from 'three';

/**
 * A signal that is aborted when the context of a renderer is lost, which takes with it what was drawn so far however soon it
 * is back, and when `signal` is.
 * @returns the signal, and what stops listening
 */
export function untilLoss(renderer: WebGLRenderer, signal?: AbortSignal): { signal: AbortSignal; end(): void } {
  const controller = new AbortController();
  const canvas = renderer.domElement;
  const lose = (): void => controller.abort(new Error('The bake ended: the WebGL context was lost.'));
  const abort = (): void => controller.abort(signal!.reason);
  canvas.addEventListener('webglcontextlost', lose);
  if (signal?.aborted) abort();
  signal?.addEventListener('abort', abort);
  return {
    signal: controller.signal,
    end() {
      canvas.removeEventListener('webglcontextlost', lose);
      signal?.removeEventListener('abort', abort);
    },
  };
}
