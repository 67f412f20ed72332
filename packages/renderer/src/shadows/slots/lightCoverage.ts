import { type Camera, type Light, type PointLight, Vector3 } from 'three';
import { lightRange } from '../../lights/lightData';
import { sphereCoverage } from '../../lights/spheres';

const position = new Vector3();

/** Approximate share of the picture that a light's range covers, 0 to 1; 1 without a range. */
export function lightCoverage(light: Light, camera: Camera): number {
  const range = lightRange(light as PointLight);
  if (range === 0) return 1;
  position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
  return sphereCoverage(-position.z, range, camera.projectionMatrix.elements);
}
