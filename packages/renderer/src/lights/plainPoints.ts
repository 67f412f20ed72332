import type { Light, PointLight } from 'three';

/** Numbers of one light in `PlainPoints`. */
export const POINT = 8;

/** Range (m) from which on a light counts as unlimited: its end is invisible, and its square would soon exceed 32-bit floats. */
const ENDLESS = 1e18;

/**
 * Values of many lights, read once a frame: world position and range (m), colour × intensity, decay; POINT numbers each. The
 * decay is NaN for a light that must be read by its class: it is not a plain point light of three's, may have a mask, or has a
 * value that is no finite number.
 */
export type PlainPoints = Float64Array;

/** Whether a light is a point light of three's without Farol's options or a mask. */
export function isPlainPoint(light: Light): light is PointLight {
  if ((light as PointLight).isPointLight !== true || light.castShadow) return false;
  const { userData } = light;
  return userData.farol === undefined && (userData.farolMap ?? userData.farolProfile ?? null) === null;
}

/**
 * Writes the numbers of a light. `points` must have room for them from `at` on.
 * @returns false for a light that must be read by its class
 */
export function readPoint(light: Light, points: PlainPoints, at: number): boolean {
  points[at + 7] = NaN;
  if (!isPlainPoint(light)) return false;
  const { elements } = light.matrixWorld;
  return writePoint(light, elements[12], elements[13], elements[14], points, at);
}

/** Writes the numbers of a plain point light at a world-space position (m). @returns as `readPoint` */
export function writePoint(
  light: PointLight,
  x: number,
  y: number,
  z: number,
  points: PlainPoints,
  at: number,
): boolean {
  const { color, intensity, decay, distance } = light;
  const r = (points[at + 4] = color.r * intensity);
  const g = (points[at + 5] = color.g * intensity);
  const b = (points[at + 6] = color.b * intensity);
  points[at] = x;
  points[at + 1] = y;
  points[at + 2] = z;
  points[at + 3] = rangeOf(distance);
  const isFinite = Number.isFinite(x + y + z + r + g + b + intensity + decay);
  points[at + 7] = isFinite ? decay : NaN;
  return isFinite;
}

/** Range (m) of a `distance` of three's lights; 0 for a distance that is no limit. */
export function rangeOf(distance: number): number {
  return distance > 0 && distance < ENDLESS ? distance : 0;
}
