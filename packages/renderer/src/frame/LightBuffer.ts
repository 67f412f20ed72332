import type { ForwardTwins } from '../materials/forwardTwin';
import type { View } from './views';
import type { LightBufferUniforms } from '../techniques/light-buffer/lightBufferUniforms';

/** The light that reaches each texel of the thin G-buffer. */
export interface LightBuffer {
  /** Uniforms of lightBufferFilter.glsl that read this buffer. */
  readonly uniforms: LightBufferUniforms;
  /** Kinds of twins that light materials by this buffer; set `farol_object` for each draw. */
  readonly twins: (view: View) => ForwardTwins;
}
