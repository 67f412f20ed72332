import { type ArrayCamera, type Camera, Object3D, type Scene, type WebGLRenderer } from 'three';

/** `onBeforeRender` and `onAfterRender` with the arguments that three passes them of a Scene. */
type SceneCallback = (webgl: WebGLRenderer, scene: Scene, camera: Camera, target?: unknown) => void;

const NO_CALLBACK = Object3D.prototype.onBeforeRender;

/** Updates the world matrix of a camera without a parent, as three does. */
export function updateCamera(camera: Camera): void {
  if (camera.parent === null && camera.matrixWorldAutoUpdate) camera.updateMatrixWorld();
}

/**
 * Calls a Scene's `onBeforeRender` if the host has set one, after updating world matrices of scene and camera. An array of
 * cameras is always updated.
 * @returns whether matrices were updated
 */
export function beforeRender(webgl: WebGLRenderer, object: Object3D, camera: Camera): boolean {
  const scene = object as Scene;
  if ((camera as ArrayCamera).isArrayCamera === true) updateCamera(camera);
  if (scene.isScene !== true || scene.onBeforeRender === NO_CALLBACK) return false;
  if (scene.matrixWorldAutoUpdate) scene.updateMatrixWorld();
  updateCamera(camera);
  (scene.onBeforeRender as unknown as SceneCallback)(webgl, scene, camera, webgl.getRenderTarget());
  return true;
}

/** Calls a Scene's `onAfterRender`. */
export function afterRender(webgl: WebGLRenderer, object: Object3D, camera: Camera): void {
  const scene = object as Scene;
  if (scene.isScene === true) (scene.onAfterRender as unknown as SceneCallback)(webgl, scene, camera);
}
