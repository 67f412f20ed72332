import type { WebGLRenderer } from 'three';

export const CONTEXT_LOST = 'The bake ended: the WebGL context was lost. Bake again once the picture is back.';

/**
 * Makes a signal that aborts when `signal` does, or when the renderer's context is lost, with all that was drawn.
 * @returns the signal, and a function that removes the listeners
 */
export function untilLoss(renderer: WebGLRenderer, signal?: AbortSignal): { signal: AbortSignal; end(): void } {
  const controller = new AbortController();
  const canvas = renderer.domElement;
  const lose = (): void => controller.abort(new Error(CONTEXT_LOST));
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
