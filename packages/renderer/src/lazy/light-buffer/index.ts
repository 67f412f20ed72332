import { addMicroShaders } from '../../microshaders/addMicroShaders';
import type { MicroShaderRegistry } from '../../microshaders';
import type { Pass } from '../../frame/Pass';
import { forwardTail } from '../../techniques/forwardTail';
import { LightBufferPass } from './LightBufferPass';
import lightBufferCounts from './lightBufferCounts.glsl?raw';
import lightBufferFilter from './lightBufferFilter.glsl?raw';
import lightLoopBuffer from './lightLoopBuffer.glsl?raw';
import lightSums from './lightSums.glsl?raw';
import { LitMaterialsPass } from './LitMaterialsPass';
import { StippledPass } from './StippledPass';
import sumLight from './sumLight.glsl?raw';
import { ThinGBufferPass } from './ThinGBufferPass';
import thinGBufferRead from './thinGBufferRead.glsl?raw';
import thinGBufferWrite from './thinGBufferWrite.glsl?raw';
import volumeLightBuffer from './volumeLightBuffer.glsl?raw';

/** Its chunks, by name. */
export const microShaders = {
  lightBufferCounts,
  lightBufferFilter,
  lightLoopBuffer,
  lightSums,
  sumLight,
  thinGBufferRead,
  thinGBufferWrite,
  volumeLightBuffer,
};

/** The passes of 'light-prepass'. */
export function lightPrepassPasses(registry: MicroShaderRegistry): Pass[] {
  addMicroShaders(registry, microShaders);
  const surfaces = new ThinGBufferPass({ scale: { value: 1 }, stipple: false });
  const lights = new LightBufferPass(surfaces);
  return [surfaces, lights, new LitMaterialsPass(surfaces, lights), ...forwardTail('lightLoopAll')];
}

/**
 * The passes of 'inferred'.
 * @param scale texels of its buffers a pixel of the picture, along a side: above 0, at most 1; read each frame
 */
export function inferredPasses(registry: MicroShaderRegistry, scale: { readonly value: number }): Pass[] {
  addMicroShaders(registry, microShaders);
  const surfaces = new ThinGBufferPass({ scale, stipple: true });
  const lights = new LightBufferPass(surfaces);
  const materials = new LitMaterialsPass(surfaces, lights);
  const [opaque, transmissive] = forwardTail('lightLoopAll');
  return [surfaces, lights, materials, opaque, transmissive, new StippledPass(surfaces, materials, 'lightLoopAll')];
}
