/** Steps of depth of 16 bits. */
const STEPS = 65536;
/** Steps of depth that a bias must span, so that single steps do not show. */
const BIAS_STEPS = 16;

/**
 * Whether a shadow map needs depths of 24 bits. 16 bits take two thirds of the time to clear. They do where a step, half way to
 * the far plane, is no more than half a texel's width, and no more than a sixteenth of the bias.
 * @param near - plane of the map's camera (m)
 * @param far - plane (m)
 * @param scale - of the projection across: one over the tangent of half the angle, or over half the width (m) where orthographic
 * @param texels - across
 * @param bias - of the shadow, in depths from 0 to 1
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
