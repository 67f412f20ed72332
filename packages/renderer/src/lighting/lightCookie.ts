import type { CubeTexture, Light, SpotLight, Texture } from 'three';

/**
 * The image that a light with a cookie (`hasCookie`) throws: a spot light's own `map`, a point light's cube texture as
 * `setLightOptions` gave it. Null for none.
 */
export function cookieOf(light: Light): Texture | null {
  const spot = light as SpotLight;
  if (spot.isSpotLight === true) return spot.map;
  return (light.userData.farolMap as CubeTexture | undefined) ?? null;
}

/** The photometric profile that `setLightOptions` gave a light; null for none. */
export function profileOf(light: Light): Texture | null {
  return (light.userData.farolProfile as Texture | undefined) ?? null;
}
