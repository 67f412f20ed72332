import type { IUniform, Texture, Vector4 } from 'three';
import type { ForwardTwins } from '../materials/forwardTwin';
import type { ThinGBufferUniforms } from './ThinGBuffer';

/** Uniforms of lightBufferFilter.glsl and lightBufferCounts.glsl. */
export interface LightBufferUniforms extends ThinGBufferUniforms {
  farol_sums0: IUniform<Texture | null>;
  farol_sums1: IUniform<Texture | null>;
  farol_sums2: IUniform<Texture | null>;
  /** Sums of the light of area lights at each texel; null without area lights. */
  farol_sums3: IUniform<Texture | null>;
  farol_lightGrid: IUniform<Vector4>;
}

/** The light that reaches each texel of the thin G-buffer. */
export interface LightBuffer {
  /** Uniforms of lightBufferFilter.glsl that read this buffer. */
  readonly uniforms: LightBufferUniforms;
  /** Twins that read their direct light from the light buffer; call `setObject` before each draw. */
  readonly twins: (view: string) => ForwardTwins;
}
