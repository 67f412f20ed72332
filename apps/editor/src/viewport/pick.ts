import { type GameObject, gameObjectOf, type Scene } from '@farol/engine';
import { type Camera, type Intersection, type Object3D, Raycaster, type Vector2 } from 'three';

export interface PickHit {
  readonly object: GameObject;
  /** Distance along the ray (m). */
  readonly distance: number;
}

const raycaster = new Raycaster();

function collect(object: Object3D, camera: Camera, hits: Intersection[]): void {
  if (!object.visible) return;
  if (object.layers.test(camera.layers)) raycaster.intersectObject(object, false, hits);
  for (const child of object.children) collect(child, camera, hits);
}

/** What a ray through a point of the picture hits first, as of the last drawn frame; null where nothing is. */
export function hitPoint(scene: Scene, camera: Camera, point: Vector2): Intersection | null {
  raycaster.setFromCamera(point, camera);
  const hits: Intersection[] = [];
  collect(scene.three, camera, hits);
  let nearest: Intersection | null = null;
  for (const hit of hits) if (!nearest || hit.distance < nearest.distance) nearest = hit;
  return nearest;
}

/**
 * The GameObject whose mesh is seen at a point of the picture.
 * @param point - normalised device coordinates, -1 to 1, y up
 */
export function pick(scene: Scene, camera: Camera, point: Vector2): PickHit | null {
  const hit = hitPoint(scene, camera, point);
  const object = hit && gameObjectOf(hit.object, hit.instanceId);
  return object ? { object, distance: hit.distance } : null;
}
