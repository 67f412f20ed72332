import { addMicroShaders } from '../../microshaders/addMicroShaders';
import type { ShadowMaskMaterials } from '../../frame/RenderQueue';
import type { MicroShaderRegistry } from '../../microshaders';
import cookieRegion from './draw/cookieRegion.glsl?raw';
import lightMaskLayers from './masks/lightMaskLayers.glsl?raw';
import lightMaskOn from './masks/lightMaskOn.glsl?raw';
import lightShadow from './masks/lightShadow.glsl?raw';
import maskFeatures from './masks/maskFeatures.glsl?raw';
import { maskRecordChunk } from './masks/maskRecordChunk';
import { mergedCaster, mergedCasterDepth } from './casters/merged';
import { ShadowMaps } from './ShadowMaps';
import shadowMask from './masks/shadowMask.glsl?raw';
import { shadowMaskTwin, showsShadowMask } from './masks/shadowMaskTwin';
import hostShadowMap from './draw/hostShadowMap.glsl?raw';
import shadowMoments from './draw/shadowMoments.glsl?raw';
import { tileMicroShaders } from './screen-tiles';
import type { WebGLRenderer } from 'three';

/** The microshaders of shadows, by name. */
export const microShaders = {
  cookieRegion,
  lightMaskLayers,
  lightMaskOn,
  lightShadow,
  maskFeatures,
  maskRecord: maskRecordChunk,
  mergedCaster,
  mergedCasterDepth,
  shadowMask,
  shadowMoments,
  hostShadowMap,
  ...tileMicroShaders,
};

export { ShadowMapCalls } from './draw/ShadowMapCalls';

/** How materials that show nothing but shadows are recognised and drawn. */
export const shadowMasks: ShadowMaskMaterials = { shows: showsShadowMask, twin: shadowMaskTwin };

/**
 * Makes what masks lights: shadow maps, cookies, layers, and their microshaders.
 * @param limit of the atlas of depths, texels a side; null: by the pictures that are drawn
 */
export function makeShadowMaps(webgl: WebGLRenderer, registry: MicroShaderRegistry, limit: number | null): ShadowMaps {
  addMicroShaders(registry, 'shadows', microShaders);
  return new ShadowMaps(webgl, registry, limit);
}
