import type { PointLight } from 'three';
import type { FarolLightData } from './FarolLightData';

/**
 * Range (m) from which on a light counts as without a range: its end is not visible, and its square nears the limit of
 * 32-bit floats.
 */
const ENDLESS = 1e18;

/** Distance from which on a light gives exactly nothing (m); 0 for a light without a range. */
export function lightRange(light: PointLight): number {
  const attenuation = (light.userData.farol as FarolLightData | undefined)?.attenuation;
  let range = light.distance;
  if (attenuation !== undefined) range = attenuation.kind === 'near-far' ? attenuation.far : attenuation.range;
  return rangeOf(range);
}

/** Range (m) of a `distance` of three's lights; 0 for a distance that is no limit. */
export function rangeOf(distance: number): number {
  return distance > 0 && distance < ENDLESS ? distance : 0;
}
