import { addMicroShaders } from '../microshaders/addMicroShaders';
import type { ShadowMaskMaterials } from '../RenderQueue';
import type { MicroShaderRegistry } from '../microshaders';
import cookieTile from './cookieTile.glsl?raw';
import lightMaskLayers from './lightMaskLayers.glsl?raw';
import lightMaskOn from './lightMaskOn.glsl?raw';
import lightShadow from './lightShadow.glsl?raw';
import maskKinds from './maskKinds.glsl?raw';
import { mergedCaster, mergedCasterDepth } from './merged';
import { ShadowMaps } from './ShadowMaps';
import shadowMask from './shadowMask.glsl?raw';
import { shadowMaskTwin, showsShadowMask } from './shadowMaskTwin';
import shownMap from './shownMap.glsl?raw';
import shadowMoments from './shadowMoments.glsl?raw';
import { tileMicroShaders } from './tiles';
import type { WebGLRenderer } from 'three';

/** Its chunks, by name. */
export const microShaders = {
  cookieTile,
  lightMaskLayers,
  lightMaskOn,
  lightShadow,
  maskKinds,
  mergedCaster,
  mergedCasterDepth,
  shadowMask,
  shadowMoments,
  shownMap,
  ...tileMicroShaders,
};

export { ShadowMapCalls } from './ShadowMapCalls';

/** Of materials that show nothing but shadows. */
export const shadowMasks: ShadowMaskMaterials = { shows: showsShadowMask, twin: shadowMaskTwin };

/**
 * What masks lights: shadow maps, cookies, layers, and their microshaders. The renderer fetches this when a scene first
 * asks for it.
 * @param limit of the atlas of depths, texels a side
 */
export function makeShadowMaps(webgl: WebGLRenderer, registry: MicroShaderRegistry, limit: number | null): ShadowMaps {
  addMicroShaders(registry, microShaders);
  return new ShadowMaps(webgl, registry, limit);
}
