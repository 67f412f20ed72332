import type { WebGLRenderer } from 'three';

/** three's render lists, which identify a context: another object after a lost context is restored. */
export function contextLists(webgl: WebGLRenderer): object {
  return webgl.renderLists;
}
