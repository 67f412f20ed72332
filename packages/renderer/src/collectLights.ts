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
  /** Children of a root that is a Scene, without managed lights that have none of their own; of another root, itself. */
  readonly rest: Object3D[];
  /** Whether to look for lights that may cast a shadow or throw an image, and how many there were. */
  seeksMasks: boolean;
  masks: number;
}

/** Finds the managed lights that the camera's layers see, parents before children. */
export function collectLights(root: Object3D, camera: Camera, left: LeftToThree, found: FoundLights): void {
  found.count = 0;
  found.masks = 0;
  found.nested.length = found.rest.length = 0;
  if ((root as Scene).isScene === true) {
    if (root.visible) visitChildren(root, camera, left, found);
  } else {
    found.rest.push(root);
    // three's traversal meets the lights that are its children too
    if (root.visible) visit(root, camera, left, found);
  }
  // what earlier frames had more of is let go
  if (found.all.length > found.count) found.all.length = found.count;
}

function visitChildren({ children }: Object3D, camera: Camera, left: LeftToThree, found: FoundLights): void {
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    const isLight = (child as Light).isLight === true;
    if (!child.visible) {
      // the scene's onBeforeRender may show it
      if (!isLight) found.rest.push(child);
      continue;
    }
    const isFound = isLight && take(child as Light, camera, left, found);
    if (isFound && child.children.length === 0) continue;
    if (isFound) found.nested.push(child as Light);
    found.rest.push(child);
    visitBelow(child, camera, left, found);
  }
}

function visit(object: Object3D, camera: Camera, left: LeftToThree, found: FoundLights): void {
  const light = object as Light;
  if (light.isLight === true && take(light, camera, left, found)) found.nested.push(light);
  visitBelow(object, camera, left, found);
}

function visitBelow({ children }: Object3D, camera: Camera, left: LeftToThree, found: FoundLights): void {
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (child.visible) visit(child, camera, left, found);
  }
}

/** @returns whether the light is a managed one that the camera's layers see */
function take(light: Light, camera: Camera, left: LeftToThree, found: FoundLights): boolean {
  if (!light.layers.test(camera.layers)) return false;
  if (found.seeksMasks && (light.castShadow || cookieOf(light) !== null)) found.masks++;
  if (!isManagedLight(light, left)) return false;
  found.all[found.count++] = light;
  return true;
}
