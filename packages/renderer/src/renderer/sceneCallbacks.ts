import { type ArrayCamera, type Camera, Object3D, type Scene, type WebGLRenderer } from 'three';

/** `onBeforeRender` and `onAfterRender` with the arguments that three passes them of a Scene. */
type SceneCallback = (webgl: WebGLRenderer, scene: Scene, camera: Camera, target?: unknown) => void;

const NO_CALLBACK = Object3D.prototype.onBeforeRender;

/** Brings a camera without a parent up to date, as three does. */
export function updateCamera(camera: Camera): void {
  if (camera.parent === null && camera.matrixWorldAutoUpdate) camera.updateMatrixWorld();
}

/**
 * Calls a Scene's `onBeforeRender`, where the host has set one, with scene and camera up to date: an array of them always.
 * @returns whether they were brought up to date
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
