import type { PhotometricProfile } from '@farol/renderer/light-profiles';

/** Radius at which the curve of the largest intensity ends, in units of the drawing. */
export const POLAR_RADIUS = 100;

/** Rings and rays of the grid. */
export const RINGS = 4;
export const RAY_DEGREES = 30;

const RADIANS = Math.PI / 180;
/** Of the curve (degrees). */
const STEP = 1;

/** A round number not below `value`: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 or 10 times a power of ten, so that quarters are round. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 1.2, 1.6, 2, 2.4, 3.2, 4, 5, 6, 8, 10].find((factor) => factor * power >= value * 0.9999)! * power;
}

/** Whether a profile has light above the level that is to be seen. */
export function shinesUp(profile: PhotometricProfile): boolean {
  const least = 0.005 * profile.maximumIntensity;
  for (let v = 95; v <= 180; v += 5)
    for (let h = 0; h < 360; h += 15) if (profile.intensityAt(v, h) > least) return true;
  return false;
}

/**
 * The polar curve of two half planes, as catalogues of luminaires draw it: down is down, the half plane of `horizontal` to the
 * right, the other one to the left.
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
