import { type DirectionalLight, type Matrix4, type SpotLight, Vector3 } from 'three';

const origin = new Vector3();

/** Puts into `axis` the unit vector from a light's target to the light, in view space. */
export function lightAxis(light: DirectionalLight | SpotLight, view: Matrix4, axis: Vector3): void {
  origin.setFromMatrixPosition(light.matrixWorld);
  axis.setFromMatrixPosition(light.target.matrixWorld);
  axis.subVectors(origin, axis).transformDirection(view);
}
