import type { WebGLRenderer } from 'three';

/**
 * Calls `free` when the context is lost: resources disposed after it was restored would be deleted by three in a
 * context that they do not belong to.
 * @returns a function that stops listening
 */
export function whenLost({ domElement }: WebGLRenderer, free: () => void): () => void {
  domElement.addEventListener('webglcontextlost', free);
  return () => domElement.removeEventListener('webglcontextlost', free);
}
