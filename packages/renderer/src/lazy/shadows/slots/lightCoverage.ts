import { type Camera, type PointLight, Vector3 } from 'three';
import { lightRange } from '../../../lights/lightRange';
import { sphereCoverage } from '../../../lights/sphereCoverage';
import type { ShadowLight } from './ShadowSlot';

const position = new Vector3();

/** Share of the picture that a light covers, roughly, 0 to 1. */
export function lightCoverage(light: ShadowLight, camera: Camera): number {
  const range = lightRange(light as PointLight);
  if (range === 0) return 1;
  position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
  return sphereCoverage(-position.z, range, camera.projectionMatrix.elements);
}
