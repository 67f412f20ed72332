import type { CubeTexture, Texture } from 'three';
import type { FarolLightData } from '../lights/lightData';

/** Properties of a light that three's lights do not have. */
export interface LightOptions extends FarolLightData {
  /**
   * Image that a point light throws in all directions, in world space: the light's colour is multiplied by what the cube
   * texture has in the direction of the surface. Six images of one size, as three's CubeTexture has them, +x to the right of
   * someone who looks along -z. (three has a `map` for spot lights alone; that one needs no option.) Kept at
   * `light.userData.farolMap`, where neither clone nor JSON see it. Default null: none.
   */
  cookie?: CubeTexture | null;
  /**
   * Photometric profile of a point or spot light: its intensity in each direction is multiplied by what the texture has there,
   * so that 1 stands for the light's `intensity` (cd). Shadow maps, cookies and a spot light's cone count as before; `ambient`
   * is not scaled.
   *
   * Directions are those of the light's own frame, as its `matrixWorld` has it. A point light hangs like a luminaire: vertical
   * angle 0 is down its -Y, horizontal angle 0 along its +X, 90° along its -Z. A spot light looks at its target: vertical
   * angle 0 is that direction, horizontal angle 0 along its +X, made perpendicular to the direction, and 90° along +Y of a
   * spot light that looks down its -Z.
   *
   * The texture's red channel counts, as `IESLoader` makes it: columns are vertical angles, the middle of the first 0 and that
   * of the last 180°; rows are horizontal angles from 0 on, 360° / rows each; one row where they make no difference. At most
   * 1024 columns and 1023 rows are used; set `texture.needsUpdate` when its data change. Kept at `light.userData.farolProfile`,
   * where neither clone nor JSON see it. Default null: none.
   */
  profile?: Texture | null;
}
