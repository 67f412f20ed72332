import { Box3, type Camera, Ray, Vector3 } from 'three';

/** On a grid of three by three by three. */
const POINTS = 27;

const inner = new Box3();
const point = new Vector3();
const projected = new Vector3();
const met = new Vector3();
const ray = new Ray();

/** Aims the ray from the eye at a point. @returns how far away it is (m) */
function aimAt(camera: Camera, at: Vector3): number {
  if (!('isOrthographicCamera' in camera)) {
    ray.origin.setFromMatrixPosition(camera.matrixWorld);
    ray.direction.copy(at).sub(ray.origin).normalize();
    return ray.origin.distanceTo(at);
  }
  // parallel rays, from the near plane
  projected.copy(at).project(camera);
  ray.origin.set(projected.x, projected.y, -1).unproject(camera);
  ray.direction.copy(at).sub(ray.origin).normalize();
  return ray.origin.distanceTo(at);
}

/** The share (0 to 1) of a box (in the world) that is outside of the picture or behind others. */
export function hiddenShare(box: Box3, obstacles: readonly Box3[], camera: Camera): number {
  let seen = 0;
  for (let i = 0; i < POINTS; i++) {
    point.set(i % 3, Math.floor(i / 3) % 3, Math.floor(i / 9)).multiplyScalar(0.5);
    point.set(
      box.min.x + (box.max.x - box.min.x) * point.x,
      box.min.y + (box.max.y - box.min.y) * point.y,
      box.min.z + (box.max.z - box.min.z) * point.z,
    );
    const { x, y, z } = projected.copy(point).project(camera);
    if (Math.abs(x) > 1 || Math.abs(y) > 1 || z < -1 || z > 1) continue;
    const distance = aimAt(camera, point);
    const isBehind = obstacles.some((each) => {
      // an eye within an obstacle looks out of it
      if (each.containsPoint(ray.origin)) return false;
      const hit = ray.intersectBox(inner.copy(each), met);
      return hit !== null && hit.distanceTo(ray.origin) < distance - 0.01;
    });
    if (!isBehind) seen++;
  }
  return 1 - seen / POINTS;
}
