import type { ForwardTwins } from '../materials/forwardTwin';
import type { View } from './views';
import type { LightBufferUniforms } from '../techniques/light-buffer/lightBufferUniforms';

/** The light that reaches each texel of the thin G-buffer. */
export interface LightBuffer {
  /** What lightBufferFilter.glsl reads of it. */
  readonly uniforms: LightBufferUniforms;
  /** Kinds by which lit materials take their direct light from it; set `farol_object` for each draw. */
  readonly twins: (view: View) => ForwardTwins;
}
