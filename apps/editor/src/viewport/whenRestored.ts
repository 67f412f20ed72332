import type { WebGLRenderer } from 'three';

/** Fulfilled when the context can be used: at once, or after it is restored. */
export function whenRestored(webgl: WebGLRenderer): Promise<void> {
  if (!webgl.getContext().isContextLost()) return Promise.resolve();
  return new Promise((resolve) => {
    webgl.domElement.addEventListener('webglcontextrestored', () => resolve(), { once: true });
  });
}
