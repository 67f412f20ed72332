import type { Light, PointLight } from 'three';

/** Numbers of one light in `PlainPoints`. */
export const POINT = 8;

/** From here on (m) a range counts as none: its end shows nowhere, and its square exceeds 32-bit floats soon after. */
const ENDLESS = 1e18;

/**
 * Values of many lights, read once a frame: world position and range (m), colour × intensity, decay; POINT numbers each.
 * The decay is NaN for a light that must be read by its class: it is no point light as three has it, may have a mask, or
 * one of its values is no finite number.
 */
export type PlainPoints = Float64Array;

/**
 * Writes the numbers of a light. `points` must have room for them from `at` on.
 * @returns false for one that must be read by its class
 */
export function readPoint(light: Light, points: PlainPoints, at: number): boolean {
  points[at + 7] = NaN;
  if ((light as PointLight).isPointLight !== true || light.castShadow) return false;
  const { userData } = light;
  if (userData.farol !== undefined || (userData.farolMap ?? userData.farolProfile ?? null) !== null) return false;
  const { color, intensity, matrixWorld, decay, distance } = light as PointLight;
  const { elements } = matrixWorld;
  const x = (points[at] = elements[12]);
  const y = (points[at + 1] = elements[13]);
  const z = (points[at + 2] = elements[14]);
  points[at + 3] = rangeOf(distance);
  const r = (points[at + 4] = color.r * intensity);
  const g = (points[at + 5] = color.g * intensity);
  const b = (points[at + 6] = color.b * intensity);
  if (!Number.isFinite(x + y + z + r + g + b + intensity + decay)) return false;
  points[at + 7] = decay;
  return true;
}

/** Range (m) of a `distance` of three's lights; 0 for a distance that is no limit. */
export function rangeOf(distance: number): number {
  return distance > 0 && distance < ENDLESS ? distance : 0;
}
