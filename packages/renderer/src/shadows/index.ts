import { addMicroShaders } from '../microshaders/addMicroShaders';
import type { Frame } from '../frame/Frame';
import cookieRegion from './draw/cookieRegion.glsl?raw';
import lightMaskLayers from './masks/lightMaskLayers.glsl?raw';
import lightMaskOn from './masks/lightMaskOn.glsl?raw';
import lightImage from './masks/lightImage.glsl?raw';
import lightShadow from './masks/lightShadow.glsl?raw';
import maskFeatures from './masks/maskFeatures.glsl?raw';
import { imageSamplersChunk } from './masks/imageSamplersChunk';
import { maskRecordChunk } from './masks/maskRecordChunk';
import { mergedCaster, mergedCasterDepth } from './casters/merged';
import { ShadowMaps } from './ShadowMaps';
import shadowMask from './masks/shadowMask.glsl?raw';
import hostShadowMap from './draw/hostShadowMap.glsl?raw';
import shadowMomentsAcross from './draw/shadowMomentsAcross.glsl?raw';
import shadowMomentsDown from './draw/shadowMomentsDown.glsl?raw';
import { tileMicroShaders } from './screen-tiles';
import { ShadowMapCalls } from './draw/ShadowMapCalls';

export const microShaders = {
  cookieRegion,
  lightMaskLayers,
  lightMaskOn,
  lightImage,
  lightShadow,
  maskFeatures,
  imageSamplers: imageSamplersChunk(4),
  maskRecord: maskRecordChunk,
  mergedCaster,
  mergedCasterDepth,
  shadowMask,
  shadowMomentsAcross,
  shadowMomentsDown,
  hostShadowMap,
  ...tileMicroShaders,
};

/** Runs a function as a pass of the frame, listed by name in `FarolInfo.passes`. */
interface PassRunner {
  run(name: string, work: () => void): void;
}

/** Creates a renderer's masks of lights (shadow maps, cookies, layers) and adds their microshaders. */
export function makeShadowMaps({ webgl, microshaders }: Frame, draws: PassRunner): ShadowMaps {
  addMicroShaders(microshaders, 'shadows', microShaders);
  const shadows = new ShadowMaps(webgl, microshaders);
  const render = (): void => shadows.render();
  shadows.calls = new ShadowMapCalls(webgl, () => shadows.hasWork && draws.run('shadow maps', render));
  return shadows;
}
