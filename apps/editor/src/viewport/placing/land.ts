import {
  Camera as CameraComponent,
  Decal,
  type GameObject,
  Light,
  ModelRenderer,
  ObjectRenderer,
  Room,
  type Scene,
} from '@farol/engine';
import { Box3, type Camera, Matrix4, Quaternion, Ray, type Vector2, Vector3 } from 'three';
import { boundsOf } from '../boundsOf';
import { boundsOfNew } from './boundsOfNew';
import { freePlace, HIDDEN_ENOUGH } from './freePlace';
import { hiddenShare } from './hiddenShare';
import { mountOf, mountPlace } from './mount';
import { groundAlong, rayThrough, type Surface, surfacesAlong } from './surfaces';

/** The view that objects are placed in. */
export interface LandingView {
  readonly scene: Scene;
  readonly camera: Camera;
  /** Orbit target (m, world). */
  readonly target: Vector3;
  /** Rounding of positions (m). */
  readonly step: number;
}

/** Distance (m): ground farther away than this, or than twice the distance to the orbit target, is ignored. */
const FARTHEST_GROUND = 60;
/** Range of distances from the eye for objects placed in empty space (m). */
const [NEAREST, FARTHEST] = [2, 15];
/** Height above the surface of lights and cameras that are placed over it (m). */
const heights: Readonly<Record<string, number>> = { point: 2.5, spot: 2.5, directional: 4, ambient: 3, hemisphere: 3 };
const EYE_HEIGHT = 1.6;
/** Assumed size of objects without a mesh (m). */
const NOMINAL = 0.5;

/**
 * Height (m) below which objects count as floors; they are raised by half of it above another floor to avoid
 * z-fighting.
 */
const FLAT = 0.02;

const DOWN = new Vector3(0, -1, 0);
const UP = new Vector3(0, 1, 0);
const size = new Vector3();
const middle = new Vector3();

const isFloor = ({ normal }: Surface): boolean => normal.y > 0.6;

/** Height above the surface at which an object without a mesh is placed (m). */
function heightOf(object: GameObject): number {
  const light = object.getComponent(Light);
  if (light) return heights[light.type] ?? 0;
  return object.getComponent(CameraComponent) ? EYE_HEIGHT : 0;
}

/** Inner box of a room (world); null when the object is no room. */
function insideOf(object: GameObject): Box3 | null {
  const room = object.getComponent(Room);
  if (!room?.enabled) return null;
  const { width, depth, height } = room;
  const box = new Box3(new Vector3(-width / 2, 0, -depth / 2), new Vector3(width / 2, height, depth / 2));
  return box.applyMatrix4(object.object3D.matrixWorld);
}

/** Inner box of the room whose floor was hit, when a box fits in. */
function roomFor({ object, point }: Surface, box: Box3): Box3 | null {
  const inside = object && insideOf(object);
  if (!inside?.containsPoint(middle.copy(point).setY(point.y + 0.01))) return null;
  box.getSize(size);
  const { x, y, z } = inside.getSize(middle);
  return size.x <= x && size.y <= y + 0.01 && size.z <= z ? inside : null;
}

/** Whether a hit object is large enough to stand on; smaller ones are obstacles. */
function canCarry(surface: Surface, box: Box3): boolean {
  const { object } = surface;
  if (!object || roomFor(surface, box)) return true;
  const below = boundsOf([object], new Box3(), false).getSize(new Vector3());
  box.getSize(size);
  return below.x >= 1.5 * size.x && below.z >= 1.5 * size.z;
}

/**
 * The floor below a point: a surface that can carry the box, else the ground at height 0; null when the point is below
 * both.
 */
function floorBelow(view: LandingView, from: Vector3, box: Box3): Surface | null {
  const ray = new Ray(from.clone(), DOWN);
  const floors = surfacesAlong(view.scene, ray, view.camera).filter((each) => isFloor(each) && canCarry(each, box));
  return floors[0] ?? groundAlong(ray, Infinity);
}

/** Whether a point is visible on screen, away from the edges. */
function isSeen(point: Vector3, camera: Camera): boolean {
  const { x, y, z } = middle.copy(point).project(camera);
  return Math.abs(x) < 0.9 && Math.abs(y) < 0.9 && z > -1 && z < 1;
}

/** Surfaces hit by a ray through a point on screen: meshes, nearest first, then the ground. */
function surfacesThrough(view: LandingView, point: Vector2): Surface[] {
  const ray = rayThrough(view.camera, point);
  const limit = Math.max(FARTHEST_GROUND, 2 * ray.origin.distanceTo(view.target));
  const ground = groundAlong(ray, limit);
  const surfaces = surfacesAlong(view.scene, ray, view.camera);
  if (!ground) return surfaces;
  return [...surfaces.filter(({ distance }) => distance <= limit), ground];
}

/** A point in empty space on the ray through a screen point, as far away as the orbit target, within limits. */
function pointBefore(view: LandingView, point: Vector2): Vector3 {
  const ray = rayThrough(view.camera, point);
  const distance = Math.min(FARTHEST, Math.max(NEAREST, ray.origin.distanceTo(view.target)));
  return ray.at(distance, new Vector3());
}

/** Whether a hit object is not much larger than a box, so that it is no wall and the box can be placed beside it. */
function isThing({ object }: Surface, box: Box3): boolean {
  if (!object) return false;
  const there = boundsOf([object], new Box3(), false).getSize(new Vector3());
  box.getSize(size);
  return Math.max(there.x, there.z) < 3 * Math.max(size.x, size.z);
}

/** The floor visible behind a small object, close to it; a new object is then placed beside the small one. */
function floorBehind(surfaces: readonly Surface[], box: Box3): Surface | null {
  const behind = surfaces.find((each) => !isThing(each, box));
  if (!behind || !isFloor(behind) || !canCarry(behind, box)) return null;
  box.getSize(size);
  const near = 3 * Math.max(size.x, size.y, size.z);
  return behind.point.distanceTo(surfaces[0].point) < near ? behind : null;
}

/** A candidate place for an object: a point on a surface; the surface is null in empty space. */
interface Stand {
  readonly at: Vector3;
  readonly on: Surface | null;
}

/** Possible places for a box at a point on screen, best first. */
function standsAt(view: LandingView, point: Vector2, box: Box3): Stand[] {
  const surfaces = surfacesThrough(view, point);
  if (surfaces.length === 0) {
    const at = pointBefore(view, point);
    const floor = floorBelow(view, at, box);
    return [floor && isSeen(floor.point, view.camera) ? { at: floor.point, on: floor } : { at, on: null }];
  }
  const [seen] = surfaces;
  if (isFloor(seen) && canCarry(seen, box)) return [{ at: seen.point, on: seen }];
  const behind = isThing(seen, box) ? floorBehind(surfaces, box) : null;
  const inFront = standBefore(view, seen, box);
  return behind ? [{ at: behind.point, on: behind }, inFront] : [inFront];
}

/** Place on the floor in front of a wall, or in front of the side of a large object. */
function standBefore(view: LandingView, seen: Surface, box: Box3): Stand {
  box.getSize(size);
  const out = seen.normal.clone().setY(0);
  const from = seen.point.clone();
  if (out.lengthSq() > 0.01) {
    out.normalize();
    from.addScaledVector(out, 0.5 * (Math.abs(out.x) * size.x + Math.abs(out.z) * size.z) + 0.01);
  }
  from.y += 0.01;
  const floor = floorBelow(view, from, box);
  return floor ? { at: floor.point, on: floor } : { at: from, on: null };
}

/**
 * Boxes of objects in the way of a new box. Objects without a mesh count as small boxes, and only for new objects
 * without one; floors are only in the way of floors.
 */
function obstaclesFor(box: Box3, scene: Scene, without: GameObject | null, isShape: boolean): Box3[] {
  const boxes: Box3[] = [];
  const isFlat = isFlatBox(box);
  scene.traverse((object) => {
    if (object === without || !object.activeInHierarchy) return;
    const draws = object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer);
    const isPlace = object.getComponent(Light) ?? object.getComponent(CameraComponent);
    if (!draws && (isShape || !(isPlace || object.components.length === 1))) return;
    const there = boundsOf([object], new Box3(), false);
    if (there.isEmpty() || isFlatBox(there) !== isFlat) return;
    if (!draws) there.expandByScalar(NOMINAL / 2);
    if (isFlat) there.max.y += FLAT / 2;
    boxes.push(there);
  });
  return boxes;
}

const isFlatBox = ({ min, max }: Box3): boolean => max.y - min.y < FLAT && max.x - min.x > 1 && max.z - min.z > 1;

/** Free height above a point (m). */
function clearanceAbove(view: LandingView, point: Vector3): number {
  const ray = new Ray(point.clone().addScaledVector(UP, 0.01), UP);
  return (surfacesAlong(view.scene, ray, view.camera)[0]?.distance ?? Infinity) + 0.01;
}

const rounded = (value: number, step: number): number => Math.round(value / step) * step;

/** Translates objects that are not in a scene yet. */
function moveBy(objects: readonly GameObject[], { x, y, z }: Vector3): void {
  for (const { transform } of objects) {
    const [px, py, pz] = transform.position;
    // coordinates are rounded to 0.1 mm, which removes rounding errors
    const tidy = (value: number): number => Number(value.toFixed(4)) + 0;
    transform.position = [tidy(px + x), tidy(py + y), tidy(pz + z)];
  }
}

/**
 * The point of objects that is placed at the pointer: the origin of a single object when it is inside its box, else the
 * box's centre.
 */
function anchorOf(objects: readonly GameObject[], box: Box3): Vector3 {
  const anchor = box.getCenter(new Vector3());
  const [x, y, z] = objects[0].transform.position;
  const isInside = x >= box.min.x && x <= box.max.x && z >= box.min.z && z <= box.max.z;
  if (objects.length === 1 && isInside) anchor.set(x, y, z);
  return anchor;
}

/** Moves a box sideways into a larger one. @returns the shift (m) */
function keepWithin(box: Box3, room: Box3): Vector3 {
  const way = new Vector3();
  for (const axis of ['x', 'z'] as const) {
    way[axis] = Math.max(0, room.min[axis] - box.min[axis]) - Math.max(0, box.max[axis] - room.max[axis]);
  }
  box.translate(way);
  return way;
}

/** Projects a decal onto a surface: its front (-Z) against the normal. */
function throwDecal(object: GameObject, { point, normal }: Surface): void {
  const up = Math.abs(normal.y) > 0.99 ? new Vector3(0, 0, -1) : UP;
  const turn = new Quaternion().setFromRotationMatrix(new Matrix4().lookAt(normal, new Vector3(), up));
  object.transform.setQuaternion(turn);
  object.transform.position = [0, 0, 0];
  moveBy([object], point);
}

/** Shortest shift (m) along a wall, by multiples of a box's width, that frees the box from obstacles; zero for none. */
function freeAlong(box: Box3, solid: readonly Box3[], side: Vector3): Vector3 {
  box.getSize(size);
  const width = Math.abs(side.x) * size.x + Math.abs(side.z) * size.z + 0.05;
  for (let step = 0; step <= 40; step++) {
    const shift = side.clone().multiplyScalar((step % 2 ? 1 : -1) * Math.ceil(step / 2) * width);
    if (freePlace(box.clone().translate(shift), solid, side, null, () => 0).lengthSq() === 0) return shift;
  }
  return new Vector3();
}

/** Mounts an object on the ceiling or wall at a screen point. @returns false without a tag for it, or no place */
function fix(view: LandingView, object: GameObject, point: Vector2): boolean {
  const mount = mountOf(object);
  if (!mount) return false;
  const { scene, camera } = view;
  const place = mountPlace(view, mount, surfacesThrough(view, point), boundsOfNew([object], scene.assets));
  if (!place) return false;
  const { x, z } = place.point;
  if (mount === 'ceiling') place.point.set(rounded(x, view.step), place.point.y, rounded(z, view.step));
  object.transform.setQuaternion(place.rotation);
  object.transform.position = [0, 0, 0];
  moveBy([object], place.point);
  const box = boundsOfNew([object], scene.assets);
  const solid = obstaclesFor(box, scene, place.on, true);
  const support = place.on ? boundsOf([place.on], new Box3(), false) : null;
  const side = new Vector3(1, 0, 0).applyQuaternion(place.rotation);
  if (mount === 'ceiling')
    moveBy(
      [object],
      freePlace(box, solid, side, support, (each, others) => hiddenShare(each, others, camera)),
    );
  else moveBy([object], freeAlong(box, solid, side));
  return true;
}

/** Rotates objects whose front is -Z to face the way the camera does, horizontally. */
function turnWithView(objects: readonly GameObject[], camera: Camera): void {
  const back = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2);
  const yaw = Number(Math.atan2(back.x, back.z).toFixed(4));
  for (const { transform } of objects) transform.rotation = [0, yaw, 0];
}

/**
 * Places objects that are not in a scene yet at a point on screen: on the surface there, in front of it when it is a
 * wall, else on the ground at height 0, else at a moderate distance from the eye. Their lowest point touches the
 * surface, beside existing objects. Lights and cameras are placed at a useful height; decals are projected onto the
 * surface; objects tagged `ceiling` hang, objects tagged `wall` are turned to their wall.
 * @param objects - at least one; their relative positions are kept
 * @param point - normalised device coordinates
 */
export function land(view: LandingView, objects: readonly GameObject[], point: Vector2): void {
  const { scene, camera } = view;
  scene.three.updateMatrixWorld();
  const [first] = objects;
  if (objects.length === 1 && first.getComponent(Decal)) {
    const surface = surfacesThrough(view, point).at(0);
    if (surface) return throwDecal(first, surface);
  }
  if (objects.length === 1 && fix(view, first, point)) return;
  const box = boundsOfNew(objects, scene.assets);
  const isShape = !box.isEmpty();
  if (!isShape) {
    for (const { transform } of objects) box.expandByPoint(middle.fromArray(transform.position));
    box.expandByScalar(NOMINAL / 2);
  }
  if (!isShape && first.getComponent(CameraComponent)) turnWithView(objects, camera);
  let shift = new Vector3();
  let leastHidden = Infinity;
  for (const stand of standsAt(view, point, box)) {
    const landed = standOn(view, objects, box, isShape, stand);
    const movedBox = box.clone().translate(landed);
    // a place hidden behind other objects is avoided, since the user would not see the new object there
    const hidden = hiddenShare(movedBox, obstaclesFor(movedBox, scene, stand.on?.object ?? null, isShape), camera);
    if (hidden < leastHidden) [shift, leastHidden] = [landed, hidden];
    if (leastHidden <= HIDDEN_ENOUGH) break;
  }
  moveBy(objects, shift);
}

/** Shift (m) that moves objects to a place, or to the nearest free one. @param box - bounds of the objects */
function standOn(
  view: LandingView,
  objects: readonly GameObject[],
  box: Box3,
  isShape: boolean,
  { at, on }: Stand,
): Vector3 {
  const { scene, camera } = view;
  if (on) {
    at.x = rounded(at.x, view.step);
    at.z = rounded(at.z, view.step);
  }
  const anchor = anchorOf(objects, box);
  const shift = at.clone().sub(anchor);
  if (isShape && on) shift.y = at.y - box.min.y + (on.object && isFlatBox(box) ? FLAT / 2 : 0);
  else if (isShape) shift.y = at.y - box.getCenter(middle).y;
  else if (on) {
    const height = heightOf(objects[0]);
    shift.y = at.y + Math.min(height, 0.8 * clearanceAbove(view, at)) - anchor.y;
  }
  const moved = box.clone().translate(shift);
  const room = on && roomFor(on, moved);
  if (room) shift.add(keepWithin(moved, room));
  const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
  if (isFlatBox(moved)) moved.max.y += FLAT / 2;
  const support = on?.object ? boundsOf([on.object], new Box3(), false) : null;
  const obstacles = obstaclesFor(moved, scene, on?.object ?? null, isShape);
  return shift.add(freePlace(moved, obstacles, right, support, (each, solid) => hiddenShare(each, solid, camera)));
}
