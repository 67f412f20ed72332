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

/** The photometric profile that `setLightProfile` gave a light; null for none. */
export function profileOf(light: Light): Texture | null {
  return (light.userData.farolProfile as Texture | undefined) ?? null;
}

/**
 * Gives a light a photometric profile: its intensity in each direction is multiplied by what the texture has there, so that
 * 1 stands for the light's `intensity` (cd). Shadow maps, cookies and a spot light's cone count as before; the ambient
 * colour of `userData.farol` is not scaled.
 *
 * Directions are those of the light's own frame, as its `matrixWorld` has it. A point light hangs like a luminaire:
 * vertical angle 0 is down its -Y, horizontal angle 0 along its +X, 90° along its -Z. A spot light looks at its target:
 * vertical angle 0 is that direction, horizontal angle 0 along its +X, made perpendicular to the direction, and 90° along
 * +Y of a spot light that looks down its -Z.
 * @param texture its red channel, as `IESLoader` makes it: columns are vertical angles, the middle of the first 0 and that of
 *   the last 180°; rows are horizontal angles from 0 on, 360° / rows each; one row where they make no difference. At most
 *   1024 columns and 1023 rows are used. Null for none. Kept at `light.userData.farolProfile`, where neither clone nor JSON
 *   see it; set `texture.needsUpdate` when its data change.
 */
export function setLightProfile(light: PointLight | SpotLight, texture: Texture | null): void {
  Object.defineProperty(light.userData, 'farolProfile', { value: texture, writable: true, configurable: true });
}
