import { HalfFloatType, LinearFilter, WebGLRenderTarget } from 'three';

/** What cookies and the moments of variance shadow maps are drawn to. @param size texels a side */
export function colourTarget(size: number): WebGLRenderTarget {
  return new WebGLRenderTarget(size, size, {
    type: HalfFloatType,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    depthBuffer: false,
  });
}
