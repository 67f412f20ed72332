import type { WebGLRenderer } from 'three';

/** @throws Error while an XR session presents: its targets and cameras are three's own */
export function refuseXR(webgl: WebGLRenderer): void {
  if (webgl.xr.isPresenting) {
    throw new Error('FarolRenderer: XR sessions are not supported; draw them with webgl.render.');
  }
}
