import type { Light } from 'three';

type AnyLight = Light & {
  isAmbientLight?: boolean;
  isHemisphereLight?: boolean;
  isDirectionalLight?: boolean;
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

/**
 * True for the lights that Farol keeps in its own table: they never change a program.
 * The others (rectangle lights, probes) stay with three.
 */
export function isManagedLight(light: Light): boolean {
  const l = light as AnyLight;
  return Boolean(l.isAmbientLight || l.isHemisphereLight || l.isDirectionalLight || l.isPointLight || l.isSpotLight);
}
