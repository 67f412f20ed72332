import type { CubeTexture, Texture } from 'three';
import type { FarolLightData } from '../lights/lightData';

/** Properties of a light that three's lights lack. */
export interface LightOptions extends FarolLightData {
  /**
   * Image that a point light projects in all directions, in world space: the cube texture's colour in the direction of the
   * surface multiplies the light's colour. Six images of one size, as in three's CubeTexture, with +x to the right for a view
   * along -z. (Spot lights have three's `map` instead.) Stored at `light.userData.farolMap`, not enumerable: `clone` and JSON do
   * not copy it. Default null: none.
   */
  cookie?: CubeTexture | null;
  /**
   * Photometric profile of a point or spot light: the texture's value multiplies its intensity in each direction, so that 1 is
   * the light's `intensity` (cd). Shadow maps, cookies and a spot light's cone still apply; `ambient` is not scaled.
   *
   * Directions are in the light's local space, by its `matrixWorld`. For a point light, as a hanging luminaire, vertical angle 0
   * is its -Y, horizontal angle 0 its +X, 90° its -Z. For a spot light, vertical angle 0 is the direction to its target,
   * horizontal angle 0 its +X made perpendicular to that direction; 90° is +Y for a spot light that looks along its -Z.
   *
   * Only the texture's red channel is read, in the layout of `IESLoader`: columns are vertical angles, 0 at the middle of the
   * first, 180° at that of the last; rows are horizontal angles from 0 on, 360° / rows each; one row for a symmetrical profile.
   * At most 1024 columns and 1023 rows are used; set `texture.needsUpdate` when its data change. Stored at
   * `light.userData.farolProfile`, not enumerable: `clone` and JSON do not copy it. Default null: none.
   */
  profile?: Texture | null;
}
