import { DepthTexture, LinearFilter, NearestFilter, RedFormat, UnsignedIntType, WebGLRenderTarget } from 'three';

/** What shadow maps are drawn to: depths, to be compared by the sampler. @param size texels a side */
export function depthTarget(size: number): WebGLRenderTarget {
  const depthTexture = new DepthTexture(size, size, UnsignedIntType);
  depthTexture.name = 'Farol shadow maps';
  depthTexture.minFilter = depthTexture.magFilter = LinearFilter;
  return new WebGLRenderTarget(size, size, {
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthTexture,
  });
}
