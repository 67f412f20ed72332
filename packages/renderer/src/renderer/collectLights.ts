import { type Camera, Group, type Light, Matrix4, Object3D, type Scene } from 'three';
import { hasCookie, hasProfile, isAreaLight, isManagedLight, type LeftToThree } from '../lights/classifyLight';
import { fetching } from '../lights/fetching';
import type { FoundLights } from '../lights/FoundLights';
import { POINT, readPoint } from '../lights/plainPoints';

const { updateMatrixWorld } = Object3D.prototype;
const identity = new Matrix4();
/** Fewest children of a scene whose lights are read by `fetching.reader`. */
const ROW = 8;

/** Update of the world matrices of children: none, those that ask for it, or all. */
const KEPT = 0;
const UPDATED = 1;
const FORCED = 2;

/**
 * Finds the managed lights that the camera's layers see, parents before children.
 * @param camera - the camera, or the array of cameras that contains it
 * @param update - brings world matrices up to date on the way, as `root.updateMatrixWorld()` would: lights are
 *   then read from memory once, not twice. Default false
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
    // three's traversal meets the lights that are its children too
    if (root.visible) visit(root, (root as Light).isLight === true, camera, left, found);
  }
  // drops references to lights of larger earlier frames
  if (found.all.length > found.count) found.all.length = found.count;
}

/** As three's `updateMatrixWorld`, without the children. @returns whether the children's matrices must be updated */
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
    // of a lamp without a shape three has nothing to traverse
    if (visit(child, isLight, camera, left, found)) found.nested.length = first;
    else found.rest.push(child);
  }
}

/**
 * Updates the matrices of a light without children, as its own `updateMatrixWorld` does.
 * @param unmoved - its parent, if the world matrix of that is the identity
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

/** Whether three does nothing with an object itself; of a class of the host's own that is not known. */
function isNode({ constructor }: Object3D): boolean {
  return constructor === Object3D || constructor === Group;
}

/** @returns whether three is not to meet the light: a managed one, or one that the camera's layers do not see */
function takesOver(light: Light, camera: Camera, left: LeftToThree, found: FoundLights): boolean {
  // an array of cameras may not see what one of its cameras does
  if (!light.layers.test(camera.layers)) return true;
  const at = found.reserve(1) * POINT;
  // a light that is read as a plain point light has no mask
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
