import type { Texture, WebGLRenderer } from 'three';
import { textureHandle } from '../three/handles';
import { bindTexture, unbindTexture } from '../three/state';

/** Switches depth comparison of a depth texture on, or (`does` false) off, so that samplers return the depth. */
export function comparesDepths(webgl: WebGLRenderer, texture: Texture, does: boolean): void {
  const gl = webgl.getContext() as WebGL2RenderingContext;
  bindTexture(webgl, gl.TEXTURE_2D, textureHandle(webgl, texture)!);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, does ? gl.COMPARE_REF_TO_TEXTURE : gl.NONE);
  const filter = does ? gl.LINEAR : gl.NEAREST;
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  unbindTexture(webgl);
}
