import { addMicroShaders } from '../../microshaders/addMicroShaders';
import type { MicroShaderRegistry } from '../../microshaders';
import type { Pass } from '../../frame/Pass';
import { forwardTail } from '../../techniques/forwardTail';
import * as chunks from './chunks';
import { LightBufferPass } from './LightBufferPass';
import { LitMaterialsPass } from './LitMaterialsPass';
import { StippledPass } from './StippledPass';
import { ThinGBufferPass } from './ThinGBufferPass';

/** Its chunks, by name. */
export const microShaders = { ...chunks };

/** The passes of 'light-prepass'. */
export function lightPrepassPasses(registry: MicroShaderRegistry): Pass[] {
  addMicroShaders(registry, 'light-buffer', microShaders);
  const surfaces = new ThinGBufferPass({ scale: { value: 1 }, stipple: false });
  const lights = new LightBufferPass(surfaces);
  return [surfaces, lights, new LitMaterialsPass(surfaces, lights), ...forwardTail('lightLoopAll')];
}

/**
 * The passes of 'inferred'.
 * @param scale texels of its buffers a pixel of the picture, along a side: above 0, at most 1; read each frame
 */
export function inferredPasses(registry: MicroShaderRegistry, scale: { readonly value: number }): Pass[] {
  addMicroShaders(registry, 'light-buffer', microShaders);
  const surfaces = new ThinGBufferPass({ scale, stipple: true });
  const lights = new LightBufferPass(surfaces);
  const materials = new LitMaterialsPass(surfaces, lights);
  const [opaque, transmissive] = forwardTail('lightLoopAll');
  return [surfaces, lights, materials, opaque, transmissive, new StippledPass(surfaces, materials, 'lightLoopAll')];
}
