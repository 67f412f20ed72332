import type { WebGLRenderer } from 'three';

/** three's WebGLState since 0.184, which remembers what it has set; before, each of three's uploads set all by itself. */
interface PixelStore {
  pixelStorei?(name: number, value: number | boolean): void;
}

/**
 * Sets the following uploads to take rows of 4-byte words as they are: not flipped, colours not multiplied by alpha.
 */
export function unpackAsIs(webgl: WebGLRenderer, gl: WebGL2RenderingContext): void {
  const store = webgl.state as PixelStore;
  const to = store.pixelStorei === undefined ? gl : store;
  to.pixelStorei!(gl.UNPACK_FLIP_Y_WEBGL, false);
  to.pixelStorei!(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  to.pixelStorei!(gl.UNPACK_ALIGNMENT, 4);
}
