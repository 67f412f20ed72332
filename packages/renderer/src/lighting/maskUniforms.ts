import { type IUniform, Matrix3, Vector2 } from 'three';

/**
 * Uniforms of shadow maps, cookies and layers of lights: of lightImage.glsl, lightShadow.glsl, shadowMask.glsl and
 * lightMaskLayers.glsl, and of tile shadows in lightLoopClustered.glsl.
 */
export interface MaskUniforms extends Record<string, IUniform> {
  readonly farol_shadowAtlas: IUniform;
  readonly farol_lightAtlas: IUniform;
  /** Textures that spot lights project, one for each sampler. */
  readonly farol_images: IUniform;
  readonly farol_atlasTexel: { value: number[] };
  /** Rotation from view space to the world's axes. */
  readonly farol_worldAxes: { value: Matrix3 };
  /** Pixel of the host's target for the first pixel of the bound target; written by `Frame.bind`. */
  readonly farol_targetOrigin: { value: Vector2 };
  readonly farol_masks: { value: number[] };
  readonly farol_layers: { value: number[] };
  readonly farol_tileShadows: IUniform;
  readonly farol_tileShadowWords: { value: number };
}

export function maskUniforms(): MaskUniforms {
  return {
    farol_shadowAtlas: { value: null },
    farol_lightAtlas: { value: null },
    farol_images: { value: [null] },
    farol_atlasTexel: { value: [1, 1] },
    farol_worldAxes: { value: new Matrix3() },
    farol_targetOrigin: { value: new Vector2() },
    farol_masks: { value: [0, 0] },
    farol_layers: { value: [0, 0] },
    farol_tileShadows: { value: null },
    farol_tileShadowWords: { value: 0 },
  };
}
