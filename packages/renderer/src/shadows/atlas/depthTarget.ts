import {
  DepthTexture,
  LinearFilter,
  NearestFilter,
  RedFormat,
  UnsignedIntType,
  UnsignedShortType,
  WebGLRenderTarget,
} from 'three';

/**
 * Makes the target of shadow maps: depths, which the sampler compares.
 * @param size - texels a side
 * @param isFine - depths have 24 bits, else 16
 */
export function depthTarget(size: number, isFine: boolean): WebGLRenderTarget {
  const depthTexture = new DepthTexture(size, size, isFine ? UnsignedIntType : UnsignedShortType);
  depthTexture.name = 'Farol shadow maps';
  depthTexture.minFilter = depthTexture.magFilter = LinearFilter;
  return new WebGLRenderTarget(size, size, {
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthTexture,
  });
}
