import { Box3, type Camera, Ray, Vector3 } from 'three';

/** Sample points of a box: a grid of 3 by 3 by 3. */
const POINTS = 27;

const inner = new Box3();
const point = new Vector3();
const projected = new Vector3();
const met = new Vector3();
const ray = new Ray();

/** Aims the ray from the eye at a point. @returns its distance (m) */
function aimAt(camera: Camera, at: Vector3): number {
  if (!('isOrthographicCamera' in camera)) {
    ray.origin.setFromMatrixPosition(camera.matrixWorld);
    ray.direction.copy(at).sub(ray.origin).normalize();
    return ray.origin.distanceTo(at);
  }
  // an orthographic camera has parallel rays, which start at its near plane
  projected.copy(at).project(camera);
  ray.origin.set(projected.x, projected.y, -1).unproject(camera);
  ray.direction.copy(at).sub(ray.origin).normalize();
  return ray.origin.distanceTo(at);
}

/** Share (0 to 1) of a box (world) that is outside the view or behind other boxes. */
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
      // an obstacle that contains the eye hides nothing
      if (each.containsPoint(ray.origin)) return false;
      const hit = ray.intersectBox(inner.copy(each), met);
      return hit !== null && hit.distanceTo(ray.origin) < distance - 0.01;
    });
    if (!isBehind) seen++;
  }
  return 1 - seen / POINTS;
}
