import type { IUniform } from 'three';
import type { LightTable } from '../lights/LightTable';
import { RECORDS_PER_MASK } from './maskRecord';
import type { ShadowMaps } from './ShadowMaps';

/** Uniforms of lightShadow.glsl, shadowMask.glsl and lightMaskLayers.glsl. */
export interface MaskUniforms extends Record<string, IUniform> {
  readonly farol_shadowAtlas: IUniform;
  readonly farol_lightAtlas: IUniform;
  readonly farol_masks: { value: number[] };
  readonly farol_layers: { value: number[] };
}

export function maskUniforms(): MaskUniforms {
  return {
    farol_shadowAtlas: { value: null },
    farol_lightAtlas: { value: null },
    farol_masks: { value: [0, 0] },
    farol_layers: { value: [0, 0] },
  };
}

/** Points them at what lights the frame, once the light table is written. */
export function setMaskUniforms(uniforms: MaskUniforms, lights: LightTable, shadows: ShadowMaps): void {
  uniforms.farol_shadowAtlas.value = shadows.depthTexture;
  uniforms.farol_lightAtlas.value = shadows.colourTexture;
  const masks = uniforms.farol_masks.value;
  masks[0] = lights.firstMask;
  masks[1] = shadows.records / RECORDS_PER_MASK;
  const layers = uniforms.farol_layers.value;
  layers[0] = lights.layers.reference & 0xffff;
  layers[1] = lights.layers.reference >>> 16;
}
