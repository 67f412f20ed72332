import type { CubeTexture, Light, SpotLight, Texture } from 'three';

/**
 * Texture that a light projects (its cookie): a spot light's own `map`, or a point light's cube texture from `setLightOptions`;
 * null for none.
 */
export function cookieOf(light: Light): Texture | null {
  const spot = light as SpotLight;
  if (spot.isSpotLight === true) return spot.map;
  return (light.userData.farolMap as CubeTexture | undefined) ?? null;
}

/** Photometric profile of a light from `setLightOptions`; null for none. */
export function profileOf(light: Light): Texture | null {
  return (light.userData.farolProfile as Texture | undefined) ?? null;
}
