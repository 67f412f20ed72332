import type { Light, SpotLight, WebGLRenderer } from 'three';

type AnyLight = Light & {
  isAmbientLight?: boolean;
  isHemisphereLight?: boolean;
  isDirectionalLight?: boolean;
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

/**
 * True for the lights that Farol keeps in its own table: they never change a program.
 * The others (rectangle lights, probes, lights that cast shadows, spot lights with a map) stay with three.
 */
export function isManagedLight(light: Light, webgl: WebGLRenderer): boolean {
  const l = light as AnyLight;
  if (l.isAmbientLight || l.isHemisphereLight) return true;
  if (!(l.isDirectionalLight || l.isPointLight || l.isSpotLight)) return false;
  if (light.castShadow && webgl.shadowMap.enabled) return false;
  return !(l.isSpotLight && (light as SpotLight).map !== null);
}
