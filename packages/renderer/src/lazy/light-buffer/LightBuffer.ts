import type { ForwardTwins } from '../../forward/forwardTwin';
import type { View } from '../../frame/views';
import type { LightBufferUniforms } from './lightBufferUniforms';

/** The light that reaches each texel of the thin G-buffer. */
export interface LightBuffer {
  /** What lightBufferFilter.glsl reads of it. */
  readonly uniforms: LightBufferUniforms;
  /** Kinds by which lit materials take their direct light from it; set `farol_object` for each draw. */
  readonly twins: (view: View) => ForwardTwins;
}
