import { type GameObject, gameObjectOf, rayHits, type Scene } from '@farol/engine';
import {
  type Camera,
  InstancedMesh,
  type Intersection,
  Matrix3,
  Matrix4,
  Ray,
  Raycaster,
  type Vector2,
  Vector3,
} from 'three';
import { castByTree } from '../trees/castByTree';

export interface Surface {
  /** World position of the hit (m). */
  readonly point: Vector3;
  /** Unit normal (world), on the side that was hit. */
  readonly normal: Vector3;
  /** Object hit; null for the ground at height 0. */
  readonly object: GameObject | null;
  /** Distance of the hit from the camera (m). */
  readonly distance: number;
}

const raycaster = new Raycaster();
const instance = new Matrix4();
const normalMatrix = new Matrix3();
const UP = new Vector3(0, 1, 0);

/** Unit normal (world) of the hit face, towards the ray's origin. */
export function normalOfHit({ face, object, instanceId }: Intersection, direction: Vector3): Vector3 {
  if (!face) return UP.clone();
  instance.copy(object.matrixWorld);
  if (instanceId !== undefined && object instanceof InstancedMesh) {
    object.getMatrixAt(instanceId, instance);
    instance.premultiply(object.matrixWorld);
  }
  const normal = face.normal.clone().applyMatrix3(normalMatrix.getNormalMatrix(instance)).normalize();
  return normal.dot(direction) > 0 ? normal.negate() : normal;
}

/** Ray through a point on screen (normalised device coordinates). */
export function rayThrough(camera: Camera, point: Vector2): Ray {
  raycaster.setFromCamera(point, camera);
  return raycaster.ray.clone();
}

/**
 * Surfaces along a ray, nearest first, as of the last drawn frame; without the ground at height 0.
 * @param without - objects to ignore, with their descendants
 */
export function surfacesAlong(
  scene: Scene,
  ray: Ray,
  camera: Camera,
  without: ReadonlySet<GameObject> | null = null,
): Surface[] {
  const surfaces: Surface[] = [];
  for (const hit of rayHits(scene, ray, camera, castByTree)) {
    const object = gameObjectOf(hit.object, hit.instanceId);
    if (!object || (without && isWithin(object, without))) continue;
    surfaces.push({ point: hit.point, normal: normalOfHit(hit, ray.direction), object, distance: hit.distance });
  }
  return surfaces;
}

/** Hit of a ray on the ground at height 0; null when there is none within `limit` (m). */
export function groundAlong(ray: Ray, limit: number): Surface | null {
  const { origin, direction } = ray;
  if (Math.abs(direction.y) < 1e-9) return null;
  const distance = -origin.y / direction.y;
  if (!(distance > 0 && distance <= limit)) return null;
  const point = ray.at(distance, new Vector3()).setY(0);
  const normal = new Vector3(0, direction.y < 0 ? 1 : -1, 0);
  return { point, normal, object: null, distance };
}

/** Whether an object or an ancestor is in a set. */
function isWithin(object: GameObject, set: ReadonlySet<GameObject>): boolean {
  for (let each: GameObject | null = object; each; each = each.parent) if (set.has(each)) return true;
  return false;
}
