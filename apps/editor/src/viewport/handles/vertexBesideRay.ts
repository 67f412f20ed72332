import type { GameObject, Scene } from '@farol/engine';
import { type BufferAttribute, type Camera, type OrthographicCamera, type Ray, Sphere, Vector3 } from 'three';
import { readableMeshes } from '../drawnMeshes';
import { isRigid } from '../trees/castByTree';
import { treeOf } from '../trees/meshTrees';

/** Largest distance from the pointer to a vertex, as a share of the view's height: 14 of 700 pixels. */
const REACH = 0.02;
/** Maximum number of vertices examined one by one per ray; beyond it, only those of meshes that the ray hits. */
const MOST_VERTICES = 300_000;
/** Depth by which a vertex may lie behind the hit and still count as visible, relative to the distance. */
const BEHIND = 1e-3;

const sphere = new Sphere();
const way = new Vector3();
const vertex = new Vector3();

/**
 * Height of the view (m): at a distance of 1 m when it grows with distance, or at any distance in an orthographic view.
 */
function heightOf(camera: Camera): { at: number; grows: boolean } {
  if ('isOrthographicCamera' in camera) {
    const { top, bottom, zoom } = camera as OrthographicCamera;
    return { at: Math.abs(top - bottom) / zoom, grows: false };
  }
  // holds for any perspective projection: 2 tan(fov / 2) / zoom
  return { at: 2 / camera.projectionMatrix.elements[5], grows: true };
}

/**
 * The vertex closest to a ray on screen, at most `REACH` from the pointer; null when there is none. Finds corners at
 * silhouettes, which the ray itself misses.
 * @param without - objects to ignore, with their descendants
 * @param limit - distance along the ray to its first hit (m), behind which vertices are hidden; Infinity for no hit
 */
export function vertexBesideRay(
  scene: Scene,
  ray: Ray,
  camera: Camera,
  without: ReadonlySet<GameObject>,
  limit: number,
): Vector3 | null {
  const { at, grows } = heightOf(camera);
  const reachAt = (distance: number): number => REACH * at * (grows ? distance : 1);
  const last = limit * (1 + BEHIND);
  let verticesLeft = MOST_VERTICES;
  let leastDistance = 1;
  let nearest: Vector3 | null = null;
  const consider = (point: Vector3): void => {
    const distance = way.copy(point).sub(ray.origin).dot(ray.direction);
    if (distance <= 0 || distance > last) return;
    const off = way.addScaledVector(ray.direction, -distance).length() / reachAt(distance);
    if (off >= leastDistance) return;
    leastDistance = off;
    nearest = (nearest ?? new Vector3()).copy(point);
  };
  const isNear = ({ center, radius }: Sphere, grown = 1): boolean => {
    const along = way.copy(center).sub(ray.origin).dot(ray.direction);
    if (along + radius < 0 || along - radius > last) return false;
    return ray.distanceToPoint(center) <= grown * radius + reachAt(Math.max(0, along) + radius);
  };
  const visit = (object: GameObject): void => {
    if (without.has(object) || !object.active) return;
    readableMeshes(object, (mesh, geometry, matrix) => {
      const positions = geometry.getAttribute('position') as BufferAttribute | undefined;
      if (!positions) return;
      if (!geometry.boundingSphere) geometry.computeBoundingSphere();
      // the geometry's bounding sphere is enlarged by half, since bones and morph targets move vertices out of it
      if (!isNear(sphere.copy(geometry.boundingSphere!).applyMatrix4(matrix), 1.5)) return;
      const tree = !mesh || isRigid(mesh) ? treeOf(geometry) : null;
      if (tree) {
        tree.shapecast({
          intersectsBounds: (box) => isNear(box.getBoundingSphere(sphere).applyMatrix4(matrix)),
          intersectsTriangle: ({ a, b, c }) => {
            for (const corner of [a, b, c]) consider(vertex.copy(corner).applyMatrix4(matrix));
          },
        });
        return;
      }
      if (positions.count > verticesLeft) return;
      verticesLeft -= positions.count;
      for (let i = 0; i < positions.count; i++) {
        if (mesh) mesh.getVertexPosition(i, vertex);
        else vertex.fromBufferAttribute(positions, i);
        consider(vertex.applyMatrix4(matrix));
      }
    });
    for (const child of object.children) visit(child);
  };
  for (const object of scene.roots) visit(object);
  return nearest;
}
