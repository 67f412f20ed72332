import { type PointLight, type SpotLight, Vector3 } from 'three';

const position = new Vector3();

/**
 * Finds the frame in which the angles of a light's photometric profile are measured, in world space, as `LightOptions.profile` says.
 * @param across - becomes the unit vector of horizontal angle 0
 * @param down - becomes the unit vector of vertical angle 0
 */
export function profileFrame(light: PointLight | SpotLight, across: Vector3, down: Vector3): void {
  const { matrixWorld } = light;
  if ((light as SpotLight).isSpotLight) {
    const { target } = light as SpotLight;
    down.setFromMatrixPosition(target.matrixWorld).sub(position.setFromMatrixPosition(matrixWorld));
  } else down.setFromMatrixColumn(matrixWorld, 1).negate();
  if (down.lengthSq() === 0) down.set(0, -1, 0);
  down.normalize();
  // where the direction lies along x, horizontal angle 0 lies along z
  for (let column = 0; column <= 2; column += 2) {
    across.setFromMatrixColumn(matrixWorld, column).normalize().addScaledVector(down, -across.dot(down));
    if (across.lengthSq() > 1e-6) break;
  }
  if (across.lengthSq() <= 1e-6) across.set(1, 0, 0).addScaledVector(down, -down.x);
  across.normalize();
}
