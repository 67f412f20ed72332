/** Steps of depth of 16 bits. */
const STEPS = 65536;
/** Steps that a bias is to have at least, so that they do not show beside it. */
const BIAS_STEPS = 16;

/**
 * Whether a shadow map needs depths of 24 bits: 16 take two thirds of the time to clear, and do where half way to the farthest
 * a step is no more than half a texel's width, and no more than a sixteenth of the bias.
 * @param near of the map's camera (m)
 * @param far of it (m)
 * @param scale of its projection across: one over the tangent of half its angle; of an orthographic one, over half its width (m)
 * @param texels across
 * @param bias of the shadow, of depths from 0 to 1
 */
export function needsFineDepth(
  near: number,
  far: number,
  scale: number,
  texels: number,
  bias: number,
  isPerspective: boolean,
): boolean {
  if (!(Math.abs(bias) * STEPS >= BIAS_STEPS)) return true;
  // at distance z a step is z² (far - near) / (near far) steps⁻¹, and a texel 2 z / (scale texels)
  const step = isPerspective ? ((far - near) / near) * 0.5 : far - near;
  return !((step * scale * texels) / (2 * STEPS) <= 0.5);
}
