import type { PhotometricProfile } from '@farol/renderer/light-profiles';

/** Radius of the outermost ring, at which the intensity is the scale's maximum (drawing units). */
export const POLAR_RADIUS = 100;

/** Number of rings of the grid, and angle between its rays (degrees). */
export const RINGS = 4;
export const RAY_DEGREES = 30;

const RADIANS = Math.PI / 180;
/** Angle between two points of the polar curve (degrees). */
const STEP = 1;

/** Rounds up to 1, 1.2, 1.6, 2, 2.4, 3.2, 4, 5, 6, 8 or 10 times a power of ten, so that quarters are round numbers. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 1.2, 1.6, 2, 2.4, 3.2, 4, 5, 6, 8, 10].find((factor) => factor * power >= value * 0.9999)! * power;
}

/** Whether a profile emits noticeable light above the horizontal. */
export function shinesUp(profile: PhotometricProfile): boolean {
  const threshold = 0.005 * profile.maximumIntensity;
  for (let v = 95; v <= 180; v += 5)
    for (let h = 0; h < 360; h += 15) if (profile.intensityAt(v, h) > threshold) return true;
  return false;
}

/**
 * Polar curve of two half planes, as in catalogues of luminaires: down is down, the half plane of `horizontal` at the
 * right, the opposite one at the left.
 * @param horizontal - angle (degrees)
 * @param scale - intensity (cd) at `POLAR_RADIUS`
 * @returns x, y of its points, y downwards
 */
export function polarCurve(profile: PhotometricProfile, horizontal: number, scale: number): [number, number][] {
  const points: [number, number][] = [];
  for (let angle = -180; angle <= 180; angle += STEP) {
    const intensity = profile.intensityAt(Math.abs(angle), angle < 0 ? horizontal + 180 : horizontal);
    const radius = (intensity / scale) * POLAR_RADIUS;
    points.push([radius * Math.sin(angle * RADIANS), radius * Math.cos(angle * RADIANS)]);
  }
  return points;
}
