/** Exponent of the slices: the last is about e to this power times as thick as the first. */
export const EXPONENT = 4;

/**
 * Scale (m) of the slices of depth between the eye and a distance: edge `i` of `n` slices is at `scale (e^(4 i / n) - 1)`.
 * @param distance - depth at which the last slice ends (m), above 0
 */
export function sliceScale(distance: number): number {
  return distance / Math.expm1(EXPONENT);
}

/** Depth (m) of a slice's edge. @param edge - 0 (the eye) to `slices` (at `distance`), with fractions between edges */
export function sliceDepth(edge: number, slices: number, distance: number): number {
  return sliceScale(distance) * Math.expm1((EXPONENT * edge) / slices);
}

/** Number of froxels across, up and in depth. */
export type Froxels = readonly [number, number, number];

/** Numbers of froxels, by quality. */
export const fogQualities = {
  lowest: [64, 36, 32],
  low: [96, 54, 32],
  medium: [160, 90, 64],
  high: [240, 135, 96],
} as const satisfies Record<string, Froxels>;

/**
 * @returns the froxels
 * @throws RangeError for numbers that a grid of froxels cannot have
 */
export function checkFroxels(froxels: Froxels): Froxels {
  const [across, up, away] = froxels;
  const whole = froxels.length === 3 && froxels.every((count) => Number.isInteger(count) && count > 0);
  if (!whole || away % 8 !== 0)
    throw new RangeError(
      `VolumetricFog: froxels is [${[across, up, away].join(', ')}]; give three whole numbers above 0, the last a multiple of 8.`,
    );
  return froxels;
}
