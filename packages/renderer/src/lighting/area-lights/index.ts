import type { IUniform, Texture, WebGLRenderer } from 'three';
import type { MicroShaderRegistry } from '../../microshaders';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import areaFeatures from './areaFeatures.glsl?raw';
import areaForms from './areaForms.glsl?raw';
import areaLightOn from './areaLightOn.glsl?raw';
import { AreaLightTable } from './AreaLightTable';
import { areaRecordChunk } from './areaRecord';
import discForm from './discForm.glsl?raw';
import rectangleForm from './rectangleForm.glsl?raw';
import tubeForm from './tubeForm.glsl?raw';

/** The microshaders of area lights, by name. */
export const microShaders = {
  areaFeatures,
  areaForms,
  areaLightOn,
  areaRecord: areaRecordChunk,
  discForm,
  rectangleForm,
  tubeForm,
};

/** Registries whose shaders have code for area lights; it is never removed, so that nothing is compiled twice. */
const adapted = new WeakSet<MicroShaderRegistry>();

/**
 * Makes the table of area lights, and adds code for them to shaders.
 * @param uniform - uniform for the table of linearly transformed cosines
 */
export function makeAreaLights(
  webgl: WebGLRenderer,
  registry: MicroShaderRegistry,
  uniform: IUniform<Texture | null>,
): AreaLightTable {
  addMicroShaders(registry, 'area-lights', microShaders);
  if (!adapted.has(registry)) registry.swap('areaLight', 'areaLightOn');
  adapted.add(registry);
  return new AreaLightTable(webgl, uniform, registry);
}
