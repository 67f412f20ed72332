import type { IUniform, Texture } from 'three';

/**
 * Uniforms of lightTable.glsl and its records, fewLights.glsl, ambientLight.glsl, lightLoopOne.glsl and areaForms.glsl; one
 * object for each FarolRenderer.
 */
export interface LightUniforms extends Record<string, IUniform> {
  readonly farol_lightTable: IUniform<Texture | null>;
  /**
   * Four counts of lights: directional; local without a range; local with a range; and, of those with a range, the ones
   * that are not plain point lights.
   */
  readonly farol_lightCounts: { value: number[] };
  /** Constant of the ambient irradiance, RGB. */
  readonly farol_ambient: { value: Float32Array };
  /** Slopes of the ambient irradiance along x, y and z of the view-space normal, 3 × RGB. */
  readonly farol_ambientSlopes: { value: Float32Array };
  /** Number of lights in the uniforms below, two texels of a record each: 0, or all lights. */
  readonly farol_fewLights: { value: number };
  readonly farol_fewSphere0: { value: Float32Array };
  readonly farol_fewSphere1: { value: Float32Array };
  readonly farol_fewEmission0: { value: Float32Array };
  readonly farol_fewEmission1: { value: Float32Array };
  /** Record of the only light of lightLoopOne.glsl. */
  readonly farol_lightIndex: { value: number };
  /** Table of linearly transformed cosines, by which area lights are shaded; null without area lights. */
  readonly farol_ltc: IUniform<Texture | null>;
  /** Two counts among the lights with a range: plain point lights, and area lights. */
  readonly farol_areaCounts: { value: number[] };
}

/** @param ambient - constant and three slopes, 4 × RGB, of which the uniforms' values are views */
export function lightUniforms(ambient: Float32Array): LightUniforms {
  return {
    farol_lightTable: { value: null },
    farol_lightCounts: { value: [0, 0, 0, 0] },
    farol_ambient: { value: ambient.subarray(0, 3) },
    farol_ambientSlopes: { value: ambient.subarray(3) },
    farol_fewLights: { value: 0 },
    farol_fewSphere0: { value: new Float32Array(4) },
    farol_fewSphere1: { value: new Float32Array(4) },
    farol_fewEmission0: { value: new Float32Array(4) },
    farol_fewEmission1: { value: new Float32Array(4) },
    farol_lightIndex: { value: 0 },
    farol_ltc: { value: null },
    farol_areaCounts: { value: [0, 0] },
  };
}
