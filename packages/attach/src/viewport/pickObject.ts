import { type Camera, type Intersection, type Object3D, Raycaster, type Vector2 } from 'three';

const raycaster = new Raycaster();
const hits: Intersection[] = [];

/**
 * The nearest visible object under a point of the picture; null when there is none.
 *
 * @param at normalised device coordinates, -1 to 1, y up
 */
export function pickObject(scene: Object3D, camera: Camera, at: Vector2): Object3D | null {
  raycaster.setFromCamera(at, camera);
  raycaster.layers.mask = camera.layers.mask;
  hits.length = 0;
  scene.traverseVisible((object) => {
    // pages switch raycasting off by taking the method away
    if (typeof object.raycast === 'function') raycaster.intersectObject(object, false, hits);
  });
  hits.sort((a, b) => a.distance - b.distance);
  return hits[0]?.object ?? null;
}
