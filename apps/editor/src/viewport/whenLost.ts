import type { WebGLRenderer } from 'three';

/**
 * Calls `free` when the context is lost: what is disposed after it is back, three would delete in a context that it does not
 * belong to.
 * @returns ends that
 */
export function whenLost({ domElement }: WebGLRenderer, free: () => void): () => void {
  domElement.addEventListener('webglcontextlost', free);
  return () => domElement.removeEventListener('webglcontextlost', free);
}
