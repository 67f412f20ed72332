import { Vector2, Vector4, type IUniform, type Texture } from 'three';
import { unprojectUniforms, type UnprojectUniforms } from '../../gpu/unprojectUniforms';

/** Uniforms of thinGBufferRead.glsl. */
export interface ThinGBufferUniforms extends UnprojectUniforms {
  farol_thinSurface: IUniform<Texture | null>;
  farol_thinDepth: IUniform<Texture | null>;
  farol_thinStored: IUniform<number>;
  /** Texels. */
  farol_size: IUniform<Vector2>;
  /** From the picture's normalised device coordinates to the buffer's. */
  farol_fit: IUniform<Vector4>;
}

/** Uniforms of lightBufferFilter.glsl and lightBufferCounts.glsl. */
export interface LightBufferUniforms extends ThinGBufferUniforms {
  farol_sums0: IUniform<Texture | null>;
  farol_sums1: IUniform<Texture | null>;
  farol_sums2: IUniform<Texture | null>;
  /** Sums of area lights; null without area lights. */
  farol_sums3: IUniform<Texture | null>;
  farol_lightGrid: IUniform<Vector4>;
}

export function thinGBufferUniforms(): ThinGBufferUniforms {
  return {
    ...unprojectUniforms(),
    farol_thinSurface: { value: null },
    farol_thinDepth: { value: null },
    farol_thinStored: { value: 0 },
    farol_size: { value: new Vector2() },
    farol_fit: { value: new Vector4() },
  };
}

export function lightBufferUniforms(): LightBufferUniforms {
  return {
    ...thinGBufferUniforms(),
    farol_sums0: { value: null },
    farol_sums1: { value: null },
    farol_sums2: { value: null },
    farol_sums3: { value: null },
    farol_lightGrid: { value: new Vector4() },
  };
}
