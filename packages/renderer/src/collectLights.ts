import type { Camera, Light, Object3D, Scene } from 'three';
import { isManagedLight, type LeftToThree } from './lights/isManagedLight';
import { cookieOf } from './lights/lightCookie';

/** Lights of a frame, in arrays that keep their length so that they need not grow again. */
export interface FoundLights {
  /** All managed lights, then whatever earlier frames left. */
  readonly all: Light[];
  /** How many of `all` are of this frame. */
  count: number;
  /** Those of them that three's traversal would meet: not children of the root itself, or with children of their own. */
  readonly nested: Light[];
  /** Whether to look for lights that may cast a shadow or throw an image, and how many there were. */
  seeksMasks: boolean;
  masks: number;
}

/** Finds the managed lights that the camera's layers see, parents before children. */
export function collectLights(root: Object3D, camera: Camera, left: LeftToThree, found: FoundLights): void {
  found.count = 0;
  found.masks = 0;
  found.nested.length = 0;
  // of another root than a Scene, three's traversal meets the lights that are its children too
  if (root.visible) visit(root, (root as Scene).isScene === true ? 0 : 2, camera, left, found);
  // what earlier frames had more of is let go
  if (found.all.length > found.count) found.all.length = found.count;
}

function visit(object: Object3D, depth: number, camera: Camera, left: LeftToThree, found: FoundLights): void {
  const { children } = object;
  const light = object as Light;
  if (light.isLight === true && object.layers.test(camera.layers)) {
    if (found.seeksMasks && (light.castShadow || cookieOf(light) !== null)) found.masks++;
    if (isManagedLight(light, left)) add(light, depth, found);
  }
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (child.visible) visit(child, depth + 1, camera, left, found);
  }
}

function add(light: Light, depth: number, found: FoundLights): void {
  found.all[found.count++] = light;
  if (depth !== 1 || light.children.length > 0) found.nested.push(light);
}
