import type { CubeTexture, Light, PointLight, SpotLight, Texture } from 'three';

/**
 * The image that a light with a cookie (`hasCookie`) throws: a spot light's own `map`, a point light's cube texture as
 * `setLightCookie` gave it. Null for none.
 */
export function cookieOf(light: Light): Texture | null {
  const spot = light as SpotLight;
  if (spot.isSpotLight === true) return spot.map;
  return (light.userData.farolMap as CubeTexture | undefined) ?? null;
}

/**
 * Gives a point light an image to throw in all directions, in world space: the light's colour is multiplied by what the
 * cube texture has in the direction of the surface. (three has a `map` for spot lights alone; that one needs no call.)
 * @param texture six images of one size, as three's CubeTexture has them, +x to the right of someone who looks along -z;
 *   null for none. Kept at `light.userData.farolMap`, where neither clone nor JSON see it.
 */
export function setLightCookie(light: PointLight, texture: CubeTexture | null): void {
  Object.defineProperty(light.userData, 'farolMap', { value: texture, writable: true, configurable: true });
}
