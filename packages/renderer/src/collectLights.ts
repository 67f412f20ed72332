import type { Camera, Light, Object3D, WebGLRenderer } from 'three';
import { isManagedLight } from './lights/isManagedLight';

/**
 * Finds the managed lights that the camera's layers see, parents before children.
 * @param out gets the lights
 * @param nested gets those of them that are not children of `root` itself, or have children
 */
export function collectLights(
  root: Object3D,
  camera: Camera,
  webgl: WebGLRenderer,
  out: Light[],
  nested: Light[],
): void {
  out.length = nested.length = 0;
  if (root.visible) visit(root, 0, camera, webgl, out, nested);
}

function visit(
  object: Object3D,
  depth: number,
  camera: Camera,
  webgl: WebGLRenderer,
  out: Light[],
  nested: Light[],
): void {
  const { children } = object;
  if (
    (object as Light).isLight === true &&
    object.layers.test(camera.layers) &&
    isManagedLight(object as Light, webgl)
  ) {
    out.push(object as Light);
    if (depth !== 1 || children.length > 0) nested.push(object as Light);
  }
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (child.visible) visit(child, depth + 1, camera, webgl, out, nested);
  }
}
