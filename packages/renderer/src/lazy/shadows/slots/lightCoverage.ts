import { type Camera, type PointLight, Vector3 } from 'three';
import { rangeOf } from '../../../lights/lightRange';
import type { ShadowLight } from './ShadowSlot';

const position = new Vector3();

/** Share of the picture that a light covers, roughly, 0 to 1. */
export function lightCoverage(light: ShadowLight, camera: Camera): number {
  const range = rangeOf((light as PointLight).distance ?? 0);
  if (range === 0) return 1;
  const p = camera.projectionMatrix.elements;
  const away = -position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse).z;
  const scale = p[11] === 0 ? range : range / Math.max(away, range);
  return Math.min(1, (Math.PI / 4) * scale * scale * Math.abs(p[0] * p[5]));
}
