import { HalfFloatType, LinearFilter, UnsignedByteType, WebGLRenderTarget } from 'three';

/**
 * Makes the target of cookies and moments of variance shadow maps.
 * @param size - texels a side
 * @param floats - whether the device draws to half floats; where not, cookies have 8 bits, and there are no moments, as in three
 */
export function colourTarget(size: number, floats: boolean): WebGLRenderTarget {
  return new WebGLRenderTarget(size, size, {
    type: floats ? HalfFloatType : UnsignedByteType,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    depthBuffer: false,
  });
}
