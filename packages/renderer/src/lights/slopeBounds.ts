/**
 * Least and greatest slope `lateral / depth`, seen from the origin, of a disc between two depths.
 * The disc must reach into that range, and `near` must be above 0.
 * @param lateral - centre (m), with depth
 * @param out - gets least and greatest slope, then the depths (m) at which the tangents to the whole disc touch it, where
 *   0 or less stands for none before the eye
 * @see Mara and McGuire 2013, 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere
 */
export function slopeBounds(
  lateral: number,
  depth: number,
  radius: number,
  near: number,
  far: number,
  out: Float64Array,
): void {
  const squared = lateral * lateral + depth * depth;
  const tangentSquared = squared - radius * radius;
  out[2] = 0;
  out[3] = 0;
  if (tangentSquared > 0) {
    const tangent = Math.sqrt(tangentSquared);
    const scale = tangent / squared;
    const low = depth * tangent + lateral * radius;
    const high = depth * tangent - lateral * radius;
    out[0] = (lateral * tangent - depth * radius) / low;
    out[1] = (lateral * tangent + depth * radius) / high;
    out[2] = low * scale;
    out[3] = high * scale;
  }
  // a tangent that touches outside of the range gives way to the end of the chord there
  if (!(out[2] >= near)) out[0] = (lateral - halfChord(depth - near, radius)) / near;
  else if (out[2] > far) out[0] = (lateral - halfChord(depth - far, radius)) / far;
  if (!(out[3] >= near)) out[1] = (lateral + halfChord(depth - near, radius)) / near;
  else if (out[3] > far) out[1] = (lateral + halfChord(depth - far, radius)) / far;
}

/** Half the width of a disc at a distance from its centre; 0 outside of it. */
export function halfChord(distance: number, radius: number): number {
  return radius === Infinity ? Infinity : Math.sqrt(Math.max(0, radius * radius - distance * distance));
}
