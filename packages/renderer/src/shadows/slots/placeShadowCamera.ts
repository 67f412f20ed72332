import { Vector3 } from 'three';
import type { PrivateLightShadow, ShadowCamera, ShadowLight } from './ShadowLight';
import { setReversedDepth } from '../../three/reversedDepth';
import { copyShadowFrustum } from '../../three/shadowFrustum';

const ahead = new Vector3();

/**
 * Leaves a light's shadow in the state that three's WebGLShadowMap would: position of the shadow's camera (for a point light, of
 * its last face), matrix and frustum.
 * @param proxy - proxy of the light's shadow, on which three's own `updateMatrices` was called
 * @param far - far plane of the map (m)
 */
export function placeShadowCamera(
  light: ShadowLight,
  proxy: PrivateLightShadow,
  far: number,
  reversedDepth: boolean,
): void {
  const shadow = light.shadow as unknown as PrivateLightShadow;
  const camera = shadow.camera as unknown as ShadowCamera;
  setReversedDepth(camera, reversedDepth);
  camera.far = far;
  if (light.isPointLight === true) {
    camera.updateProjectionMatrix();
    camera.position.setFromMatrixPosition(light.matrixWorld);
    camera.up.set(0, -1, 0);
    camera.lookAt(ahead.copy(camera.position).setZ(camera.position.z - 1));
    camera.updateMatrixWorld();
    shadow.matrix.makeTranslation(-camera.position.x, -camera.position.y, -camera.position.z);
    return;
  }
  const from = proxy.camera as unknown as ShadowCamera;
  if (camera.isPerspectiveCamera) {
    camera.fov = from.fov;
    camera.aspect = from.aspect;
  }
  camera.position.copy(from.position);
  camera.quaternion.copy(from.quaternion);
  camera.matrix.copy(from.matrix);
  camera.matrixWorld.copy(from.matrixWorld);
  camera.matrixWorldInverse.copy(from.matrixWorldInverse);
  camera.projectionMatrix.copy(from.projectionMatrix);
  camera.projectionMatrixInverse.copy(from.projectionMatrixInverse);
  shadow.matrix.copy(proxy.matrix);
  copyShadowFrustum(proxy, shadow);
}
