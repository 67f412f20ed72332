import type { RectAreaLight } from 'three';
import type { AreaLightShape } from './FarolLightData';

const shapes: readonly AreaLightShape[] = ['rectangle', 'disc', 'tube'];

/**
 * Makes a RectAreaLight another shape; stock three draws it as a rectangle all the same. Kept as JSON at
 * `light.userData.farol`.
 * @param shape 'rectangle', as in three; 'disc': the ellipse in it; both shine along the light's -z. 'tube': `width` long
 *   along the light's x, `height` thick, shines all round but not at its ends; right where it is thin against its distance
 * @throws RangeError for another shape
 */
export function setAreaLightShape(light: RectAreaLight, shape: AreaLightShape): void {
  if (!shapes.includes(shape)) {
    throw new RangeError(`setAreaLightShape: the shape is "${shape}"; give ${shapes.join(', ')}.`);
  }
  light.userData.farol = { ...light.userData.farol, shape };
}
