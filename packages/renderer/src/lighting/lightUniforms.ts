import type { IUniform, Texture } from 'three';

/**
 * Uniforms of lightTable.glsl and its records, ambientLight.glsl, lightLoopOne.glsl and areaForms.glsl; one set a
 * FarolRenderer.
 */
export interface LightUniforms extends Record<string, IUniform> {
  readonly farol_lightTable: IUniform<Texture | null>;
  /**
   * Four counts of lights: directional; local without a range; local with a range; and, of those with a range, the ones
   * that are not plain point lights.
   */
  readonly farol_lightCounts: { value: number[] };
  /** Constant and three slopes (x, y, z of the view-space normal) of the ambient irradiance, 4 × RGB. */
  readonly farol_ambient: { value: Float32Array };
  /** Record of the light that lightLoopOne.glsl shades by. */
  readonly farol_lightIndex: { value: number };
  /** Table of linearly transformed cosines, by which area lights are shaded; null without area lights. */
  readonly farol_ltc: IUniform<Texture | null>;
  /** Two counts among the lights with a range: plain point lights, and area lights. */
  readonly farol_areaCounts: { value: number[] };
}

export function lightUniforms(ambient: Float32Array): LightUniforms {
  return {
    farol_lightTable: { value: null },
    farol_lightCounts: { value: [0, 0, 0, 0] },
    farol_ambient: { value: ambient },
    farol_lightIndex: { value: 0 },
    farol_ltc: { value: null },
    farol_areaCounts: { value: [0, 0] },
  };
}
