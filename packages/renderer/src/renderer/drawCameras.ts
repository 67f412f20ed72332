import type { ArrayCamera, Camera, Object3D, WebGLRenderer } from 'three';
import { Lazy } from '../frame/Lazy';
import type { Session } from '../frame/Session';
import { afterRender, beforeRender } from './sceneCallbacks';

/** Code that draws by each camera of an array, into the camera's part of the target. */
export const arrayCode = new Lazy('camera-arrays', () => import('./camera-arrays'), 'three draws arrays of cameras');

/**
 * Draws a scene by one camera.
 * @param update - whether to update the scene's world matrices; `updatesCamera`: whether to update the camera's
 * @param seenBy - array of cameras that contains the camera; its layers select lights too; without an array, the camera
 */
export type DrawByCamera = (
  scene: Object3D,
  camera: Camera,
  update: boolean,
  updatesCamera: boolean,
  seenBy: Camera,
  session: Session | null,
) => void;

/** Draws a scene by a camera, or by each camera of an array, between `onBeforeRender` and `onAfterRender` of the scene. */
export function drawCameras(
  webgl: WebGLRenderer,
  scene: Object3D,
  camera: Camera,
  session: Session | null,
  draw: DrawByCamera,
): void {
  const isArray = 'isArrayCamera' in camera;
  if (isArray && !arrayCode.ask()) return webgl.render(scene, camera);
  // if false, `collectLights` updates the matrices while it traverses the scene
  const updated = beforeRender(webgl, scene, camera);
  const update = scene.matrixWorldAutoUpdate && !updated;
  if (!isArray) draw(scene, camera, update, !updated, camera, session);
  else {
    arrayCode.required.renderArray(webgl, camera as ArrayCamera, (one, i) => {
      if (session !== null) session.eye = i;
      draw(scene, one, update, true, camera, session);
    });
  }
  afterRender(webgl, scene, camera);
}
