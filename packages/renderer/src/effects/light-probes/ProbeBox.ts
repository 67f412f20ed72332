/** Box of a probe grid (world space), divided into equal cells with a probe in the middle of each. */
export interface ProbeBox {
  /** Corners of the box (m). */
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
  /** Number of cells along x, y and z, each at least 1. */
  readonly counts: readonly [number, number, number];
}

/** Number of probes of a grid. */
export const probeCount = ({ counts }: ProbeBox): number => counts[0] * counts[1] * counts[2];

/** Positions of a grid's probes (m), three numbers each, x varies fastest, z slowest. */
export function probePoints(box: ProbeBox): Float32Array<ArrayBuffer> {
  const { min, max, counts } = box;
  const points = new Float32Array(3 * probeCount(box));
  let at = 0;
  for (let z = 0; z < counts[2]; z++) {
    for (let y = 0; y < counts[1]; y++) {
      for (let x = 0; x < counts[0]; x++) {
        points[at++] = min[0] + ((x + 0.5) * (max[0] - min[0])) / counts[0];
        points[at++] = min[1] + ((y + 0.5) * (max[1] - min[1])) / counts[1];
        points[at++] = min[2] + ((z + 0.5) * (max[2] - min[2])) / counts[2];
      }
    }
  }
  return points;
}
