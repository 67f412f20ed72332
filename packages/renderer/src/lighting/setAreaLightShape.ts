import type { RectAreaLight } from 'three';
import { areaCode } from '../frame/lazyCode';
import type { AreaLightShape } from '../lights/FarolLightData';

const SHAPES = 'rectangle, disc, tube';

/**
 * Makes a RectAreaLight another shape; stock three draws it as a rectangle all the same. Kept as JSON at
 * `light.userData.farol`. Has the code of area lights fetched.
 * @param shape 'rectangle', as in three; 'disc': the ellipse in it; both shine along the light's -z. 'tube': `width` long
 *   along the light's x, `height` thick, shines all round but not at its ends; right where it is thin against its distance
 * @throws RangeError for another shape
 */
export function setAreaLightShape(light: RectAreaLight, shape: AreaLightShape): void {
  // called by JavaScript too
  if (!SHAPES.split(', ').includes(shape)) throw new RangeError(`Farol: "${shape}" is no shape; give ${SHAPES}.`);
  light.userData.farol = { ...light.userData.farol, shape };
  areaCode.ask();
}
