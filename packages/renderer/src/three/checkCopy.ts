import { REVISION, WebGLRenderer } from 'three';

/**
 * Checks that the host's renderer comes from the copy of three that Farol imports. Farol does not recognise materials of
 * another copy, so that three draws them.
 * @throws Error where the other copy has another version, whose shaders do not fit
 */
export function checkCopy(webgl: WebGLRenderer): void {
  if (webgl instanceof WebGLRenderer) return;
  const own = `three.js r${REVISION}`;
  // three sets the attribute on canvases of a page, not on an OffscreenCanvas
  const host = (webgl as WebGLRenderer).domElement?.getAttribute?.('data-engine') ?? own;
  const message = `Farol: the page loads three twice: ${host} made the WebGLRenderer, Farol imports ${own}. Load one, by the import map or the bundler's resolve.dedupe: ['three'].`;
  if (host !== own) throw new Error(message);
  console.warn(message);
}
