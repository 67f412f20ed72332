import type { DataTexture, Texture, WebGLRenderer } from 'three';

/** The texels of a texture of 32-bit floats with four channels that was drawn to, row after row. */
export function readTexels(webgl: WebGLRenderer, texture: Texture): Float32Array {
  const gl = webgl.getContext() as WebGL2RenderingContext;
  const { width, height } = texture.image as DataTexture['image'];
  const { __webglTexture: handle } = webgl.properties.get(texture) as { __webglTexture: WebGLTexture };
  const texels = new Float32Array(width * height * 4);
  const framebuffer = gl.createFramebuffer();
  webgl.state.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, handle, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
  webgl.state.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(framebuffer);
  return texels;
}
