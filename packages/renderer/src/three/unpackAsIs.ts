import type { WebGLRenderer } from 'three';

/** three's WebGLState since 0.184, which caches pixel-store parameters; older ones set all of them at each upload. */
interface PixelStore {
  pixelStorei?(name: number, value: number | boolean): void;
}

/** Sets the pixel store for uploads of 4-byte words: not flipped, not multiplied by alpha. */
export function unpackAsIs(webgl: WebGLRenderer, gl: WebGL2RenderingContext): void {
  const store = webgl.state as PixelStore;
  const to = store.pixelStorei === undefined ? gl : store;
  to.pixelStorei!(gl.UNPACK_FLIP_Y_WEBGL, false);
  to.pixelStorei!(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  to.pixelStorei!(gl.UNPACK_ALIGNMENT, 4);
}
