import type { PointLight } from 'three';
import type { FarolLightData } from './FarolLightData';

/** A range as wide shows nowhere, and its square is about the largest number of 32 bits (m). */
const ENDLESS = 1e18;

/** Distance from which the light gives exactly nothing (m); 0 when there is none, as for a range that is not above 0. */
export function lightRange(light: PointLight): number {
  const attenuation = (light.userData.farol as FarolLightData | undefined)?.attenuation;
  let range = light.distance;
  if (attenuation !== undefined) range = attenuation.kind === 'near-far' ? attenuation.far : attenuation.range;
  return rangeOf(range);
}

/** A distance as three's lights have it: 0 when it is no limit. */
export function rangeOf(distance: number): number {
  return distance > 0 && distance < ENDLESS ? distance : 0;
}
