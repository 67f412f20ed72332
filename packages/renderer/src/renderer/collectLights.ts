import { type Camera, Group, type Light, Matrix4, Object3D, type Scene } from 'three';
import { hasCookie, hasProfile, isAreaLight, isManagedLight, type LeftToThree } from '../lights/classifyLight';
import { fetching } from '../lights/fetching';
import type { FoundLights } from '../lights/FoundLights';
import { POINT, readPoint } from '../lights/plainPoints';

const { updateMatrixWorld } = Object3D.prototype;
const identity = new Matrix4();
/** Number of children from which on their lights are read in one go, by `fetching.reader`. */
const ROW = 8;

/** Update of children's world matrices: none, those with `matrixWorldNeedsUpdate`, or all. */
const KEPT = 0;
const UPDATED = 1;
const FORCED = 2;

/**
 * Finds the managed lights that the camera's layers see, parents before children.
 * @param camera - the camera, or the array of cameras that contains it
 * @param update - whether to update world matrices on the way, as `root.updateMatrixWorld()` would: each light is then visited
 *   once, not twice. Default false
 */
export function collectLights(
  root: Object3D,
  camera: Camera,
  left: LeftToThree,
  found: FoundLights,
  update = false,
): void {
  found.begin();
  const isScene = (root as Scene).isScene === true;
  const byChild = update && isScene && root.visible && root.updateMatrixWorld === updateMatrixWorld;
  if (update && !byChild) root.updateMatrixWorld();
  if (isScene) {
    if (byChild) visitChildren(root, camera, left, found, updateOne(root, false) ? FORCED : UPDATED);
    else if (root.visible) visitChildren(root, camera, left, found, KEPT);
  } else {
    found.rest.push(root);
    // three's traversal also visits lights that are children of the root
    if (root.visible) visit(root, (root as Light).isLight === true, camera, left, found);
  }
  // drops references to lights of earlier frames that had more lights
  if (found.all.length > found.count) found.all.length = found.count;
}

/** Does as three's `updateMatrixWorld`, but for one object. @returns whether its children's matrices must be updated */
function updateOne(object: Object3D, force: boolean): boolean {
  if (object.matrixAutoUpdate) object.updateMatrix();
  if (!(object.matrixWorldNeedsUpdate || force)) return false;
  if (object.matrixWorldAutoUpdate) {
    const { parent, matrix, matrixWorld } = object;
    if (parent === null) matrixWorld.copy(matrix);
    else matrixWorld.multiplyMatrices(parent.matrixWorld, matrix);
  }
  object.matrixWorldNeedsUpdate = false;
  return true;
}

function visitChildren(
  parent: Object3D,
  camera: Camera,
  left: LeftToThree,
  found: FoundLights,
  matrices: typeof KEPT | typeof UPDATED | typeof FORCED,
): void {
  const { children } = parent;
  const unmoved = matrices !== KEPT && parent.matrixWorld.equals(identity);
  const reader = unmoved && !left.all && children.length >= ROW ? fetching.reader : null;
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    const isLight = (child as Light).isLight === true;
    const next = isLight && reader ? reader.readPoints(parent, i, camera.layers.mask, found) : i;
    if (next > i) {
      i = next - 1;
      continue;
    }
    if (isLight && child.children.length === 0) {
      if (matrices !== KEPT) updateLight(child as Light, unmoved ? parent : null, matrices === FORCED);
      if (!child.visible || takesOver(child as Light, camera, left, found)) continue;
      found.rest.push(child);
      continue;
    }
    if (matrices !== KEPT) child.updateMatrixWorld(matrices === FORCED);
    if (!child.visible) continue;
    const first = found.nested.length;
    // a child that holds nothing but managed lights is left out of three's traversal
    if (visit(child, isLight, camera, left, found)) found.nested.length = first;
    else found.rest.push(child);
  }
}

/**
 * Updates the matrices of a light without children, as its own `updateMatrixWorld` does.
 * @param unmoved - parent of the light, if its world matrix is the identity; else null
 */
function updateLight(light: Light, unmoved: Object3D | null, force: boolean): void {
  if (light.updateMatrixWorld !== updateMatrixWorld) light.updateMatrixWorld(force);
  else if (unmoved !== null && light.parent === unmoved && light.matrixAutoUpdate && light.matrixWorldAutoUpdate) {
    light.updateMatrix();
    light.matrixWorld.copy(light.matrix);
    light.matrixWorldNeedsUpdate = false;
  } else updateOne(light, force);
}

/** @returns whether the object is nothing but managed lights and the nodes that hold them */
function visit(object: Object3D, isLight: boolean, camera: Camera, left: LeftToThree, found: FoundLights): boolean {
  const isTaken = isLight && takesOver(object as Light, camera, left, found);
  if (isTaken) found.nested.push(object as Light);
  const { children } = object;
  let isLights = isTaken || (!isLight && children.length > 0);
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (!child.visible || visit(child, (child as Light).isLight === true, camera, left, found)) continue;
    // the target of a spot light may be its child
    isLights &&= isLight && child.children.length === 0 && isNode(child);
  }
  return isLights && (isLight || isNode(object));
}

/** Whether three draws nothing for the object itself; false for a class of the host's own, which may. */
function isNode({ constructor }: Object3D): boolean {
  return constructor === Object3D || constructor === Group;
}

/** @returns whether to hide the light from three: Farol lights it, or the camera's layers do not see it */
function takesOver(light: Light, camera: Camera, left: LeftToThree, found: FoundLights): boolean {
  // `camera` may be an array, whose layers hide a light that its single cameras would see
  if (!light.layers.test(camera.layers)) return true;
  const at = found.reserve(1) * POINT;
  // a light read as a plain point light has no shadow map, cookie or profile
  if (!readPoint(light, found.points, at) || left.all) {
    if (found.seeksMasks && (light.castShadow || hasCookie(light) || hasProfile(light))) found.masks++;
    if (!isManagedLight(light, left)) {
      found.left++;
      if (!isAreaLight(light)) return false;
      found.hasArea = true;
      // an area light that casts shadows is dark until its code is loaded: three would warn of it in each frame
      return light.castShadow;
    }
  }
  found.add(light);
  return true;
}
