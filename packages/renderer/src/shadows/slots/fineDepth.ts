/** Number of depth values of a 16-bit shadow map. */
const STEPS = 65536;
/** Smallest number of depth steps in a bias, so that single steps do not show. */
const BIAS_STEPS = 16;

/**
 * Whether a shadow map needs depths of 24 bits. 16 bits are cleared in two thirds of the time; they suffice if a step
 * of depth, half way to the far plane, is at most half a texel's width and a sixteenth of the bias.
 * @param near - near plane of the map's camera (m)
 * @param far - far plane (m)
 * @param scale - horizontal scale of the projection: one over the tangent of half the angle, or over half the width (m)
 * where orthographic
 * @param texels - width of the map
 * @param bias - bias of the shadow, in depths from 0 to 1
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
