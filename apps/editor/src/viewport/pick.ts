import { type GameObject, gameObjectOf, type Scene } from '@farol/engine';
import { type Camera, type Intersection, type Object3D, type Ray, Raycaster, SkinnedMesh, type Vector2 } from 'three';

export interface PickHit {
  readonly object: GameObject;
  /** Distance along the ray (m). */
  readonly distance: number;
}

const raycaster = new Raycaster();

function collect(object: Object3D, camera: Camera, hits: Intersection[]): void {
  if (!object.visible) return;
  if (object.layers.test(camera.layers)) {
    // three remembers how large it was in the first pose: the bones may have it elsewhere now
    if (object instanceof SkinnedMesh) object.computeBoundingSphere();
    raycaster.intersectObject(object, false, hits);
  }
  for (const child of object.children) collect(child, camera, hits);
}

/**
 * What a ray through a point of the picture hits first, as of the last drawn frame; null where nothing is. Bones, morphs
 * and instances count as they are drawn.
 * @param counts - whether something that is hit counts; everything does when absent
 */
export function hitPoint(
  scene: Scene,
  camera: Camera,
  point: Vector2,
  counts: (hit: Intersection) => boolean = () => true,
): Intersection | null {
  raycaster.setFromCamera(point, camera);
  raycaster.layers.mask = camera.layers.mask;
  const hits: Intersection[] = [];
  collect(scene.three, camera, hits);
  let nearest: Intersection | null = null;
  for (const hit of hits) if ((!nearest || hit.distance < nearest.distance) && counts(hit)) nearest = hit;
  return nearest;
}

/**
 * All that a ray hits, nearest first, as of the last drawn frame; counted as `hitPoint` does.
 * @param camera - whose layers count
 */
export function rayHits(scene: Scene, ray: Ray, camera: Camera): Intersection[] {
  raycaster.ray.copy(ray);
  raycaster.camera = camera;
  raycaster.layers.mask = camera.layers.mask;
  const hits: Intersection[] = [];
  collect(scene.three, camera, hits);
  return hits.sort((a, b) => a.distance - b.distance);
}

/**
 * The GameObject whose mesh is seen at a point of the picture; through those that are locked.
 * @param point - normalised device coordinates, -1 to 1, y up
 */
export function pick(scene: Scene, camera: Camera, point: Vector2): PickHit | null {
  const ownerOf = (hit: Intersection): GameObject | null => gameObjectOf(hit.object, hit.instanceId);
  const hit = hitPoint(scene, camera, point, (each) => {
    const owner = ownerOf(each);
    return owner !== null && !owner.lockedInHierarchy;
  });
  const object = hit && ownerOf(hit);
  return object ? { object, distance: hit.distance } : null;
}
