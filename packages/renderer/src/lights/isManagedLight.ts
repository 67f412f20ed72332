import type { Light, SpotLight } from 'three';

type AnyLight = Light & {
  isAmbientLight?: boolean;
  isHemisphereLight?: boolean;
  isDirectionalLight?: boolean;
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

/** What of the lights with a shadow map or an image is left to three. */
export interface LeftToThree {
  /** Lights that cast shadows. */
  shadows: boolean;
  /** Spot lights with a map. */
  cookies: boolean;
  /** All lights: something in the scene has a shader that Farol's loop is not in. */
  all: boolean;
}

/**
 * True for the lights that Farol keeps in its own table: they never change a program.
 * The others (rectangle lights, probes) stay with three, and until their code is there those of `left`.
 */
export function isManagedLight(light: Light, left: LeftToThree): boolean {
  if (left.all) return false;
  const l = light as AnyLight;
  if (l.isAmbientLight || l.isHemisphereLight) return true;
  if (!(l.isDirectionalLight || l.isPointLight || l.isSpotLight)) return false;
  return !(left.shadows && light.castShadow) && !(left.cookies && l.isSpotLight && (light as SpotLight).map !== null);
}
