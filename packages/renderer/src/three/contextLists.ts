import type { WebGLRenderer } from 'three';

/** three's render lists: another object once a lost context is restored. */
export function contextLists(webgl: WebGLRenderer): object {
  return webgl.renderLists;
}
