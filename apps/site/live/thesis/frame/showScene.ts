import type { Scene } from '@farol/engine';
import { Color } from 'three';
import type { Figure } from './Figure';

/**
 * Puts the figure's camera where a scene's own camera looks from.
 * @param distance - to the point that the camera turns about (m)
 */
export function lookAsScene(figure: Figure, scene: Scene, distance: number): void {
  const own = scene.activeCamera!.three;
  scene.three.updateMatrixWorld(true);
  own.updateWorldMatrix(true, false);
  figure.camera.position.setFromMatrixPosition(own.matrixWorld);
  own.getWorldDirection(figure.orbit.target).multiplyScalar(distance).add(figure.camera.position);
  if ('fov' in own) Object.assign(figure.camera, { fov: own.fov, near: own.near, far: own.far });
  figure.camera.updateProjectionMatrix();
  figure.orbit.update();
  scene.three.background = new Color().setRGB(...(scene.settings.backgroundColour as [number, number, number]));
}
