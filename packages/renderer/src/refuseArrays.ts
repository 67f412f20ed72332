import type { ArrayCamera, Camera, WebGLRenderer } from 'three';

/** @throws Error for cameras that draw several pictures at once, which Farol does not do */
export function refuseArrays(webgl: WebGLRenderer, camera: Camera): void {
  if ((camera as ArrayCamera).isArrayCamera === true) {
    throw new Error('FarolRenderer: ArrayCamera is not supported; render each of its cameras by a call of its own.');
  }
  if (webgl.xr.isPresenting) {
    throw new Error('FarolRenderer: XR sessions are not supported; draw them with webgl.render.');
  }
}
