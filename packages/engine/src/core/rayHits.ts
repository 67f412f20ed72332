import {
  type Camera,
  type Intersection,
  Mesh,
  type Object3D,
  type Ray,
  Raycaster,
  SkinnedMesh,
  type Vector2,
} from 'three';
import { hasReadableVertices } from '@farol/renderer/vertex-data';
import type { Scene } from './Scene';

/**
 * Intersects a raycaster's ray with a mesh in place of three, for instance with a BVH of its triangles: adds hits to
 * `hits`.
 * @returns false when three shall intersect the mesh
 */
export type MeshCaster = (mesh: Mesh, raycaster: Raycaster, hits: Intersection[]) => boolean;

const raycaster = new Raycaster();
const found: Intersection[] = [];

/** False for objects whose vertices the CPU cannot read. */
function isCastable(object: Object3D): boolean {
  const { geometry } = object as Partial<Mesh>;
  return geometry === undefined || Object.hasOwn(object, 'raycast') || hasReadableVertices(geometry);
}

function castAt(object: Object3D, hits: Intersection[], cast: MeshCaster | undefined): void {
  // three keeps the bounding sphere of the first pose; the bones may have moved out of it
  if (object instanceof SkinnedMesh) object.computeBoundingSphere();
  const isCast = cast !== undefined && object instanceof Mesh && cast(object, raycaster, hits);
  if (!isCast) raycaster.intersectObject(object, false, hits);
}

function collect(object: Object3D, camera: Camera, hits: Intersection[], cast: MeshCaster | undefined): void {
  if (!object.visible) return;
  if (object.layers.test(camera.layers)) {
    if (isCastable(object)) castAt(object, hits, cast);
  }
  for (const child of object.children) collect(child, camera, hits, cast);
}

/**
 * First hit of a ray through a point of the picture, with the world matrices of the last frame; null for none. Bones,
 * morphs and instances are hit as drawn.
 * @param point - normalised device coordinates, -1 to 1, y up
 * @param counts - filter of hits; all hits when absent
 * @param cast - intersects meshes in place of three
 */
export function hitPoint(
  scene: Scene,
  camera: Camera,
  point: Vector2,
  counts?: (hit: Intersection) => boolean,
  cast?: MeshCaster,
): Intersection | null {
  raycaster.setFromCamera(point, camera);
  raycaster.layers.mask = camera.layers.mask;
  collect(scene.three, camera, found, cast);
  let nearest: Intersection | null = null;
  for (const hit of found) {
    if ((!nearest || hit.distance < nearest.distance) && (!counts || counts(hit))) nearest = hit;
  }
  found.length = 0;
  return nearest;
}

/**
 * All hits of a ray, nearest first, under the same conditions as `hitPoint`.
 * @param camera - only objects on its layers are hit
 * @param cast - intersects meshes in place of three
 */
export function rayHits(scene: Scene, ray: Ray, camera: Camera, cast?: MeshCaster): Intersection[] {
  raycaster.ray.copy(ray);
  raycaster.camera = camera;
  raycaster.layers.mask = camera.layers.mask;
  const hits: Intersection[] = [];
  collect(scene.three, camera, hits, cast);
  return hits.sort((a, b) => a.distance - b.distance);
}
