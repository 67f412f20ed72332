import type { PointLight } from 'three';
import type { FarolLightData } from './FarolLightData';

/** Distance from which the light gives exactly nothing (m); 0 when there is none. */
export function lightRange(light: PointLight): number {
  const attenuation = (light.userData.farol as FarolLightData | undefined)?.attenuation;
  if (attenuation === undefined) return light.distance;
  return attenuation.kind === 'near-far' ? attenuation.far : attenuation.range;
}
