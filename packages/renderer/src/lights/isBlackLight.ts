import type { Light } from 'three';
import type { FarolLightData } from './FarolLightData';

/** True if a directional, point or spot light gives nothing to any surface. */
export function isBlackLight(light: Light): boolean {
  const { r, g, b } = light.color;
  const data = light.userData.farol as FarolLightData | undefined;
  return (
    light.intensity === 0 ||
    (r === 0 && g === 0 && b === 0 && data?.ambient === undefined && data?.specular === undefined)
  );
}
