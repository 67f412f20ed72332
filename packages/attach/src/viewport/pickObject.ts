import { type Camera, type Intersection, type Mesh, type Object3D, Raycaster, type Vector2 } from 'three';
import { isReadable } from './isReadable';

const raycaster = new Raycaster();
const hits: Intersection[] = [];
const skipped = new WeakSet<Object3D>();

/**
 * The nearest visible object under a point of the picture; null when there is none. Objects whose vertices are on the
 * GPU only cannot be picked; each is named in one warning.
 *
 * @param at - normalised device coordinates, -1 to 1, y up
 */
export function pickObject(scene: Object3D, camera: Camera, at: Vector2): Object3D | null {
  raycaster.setFromCamera(at, camera);
  raycaster.layers.mask = camera.layers.mask;
  hits.length = 0;
  scene.traverseVisible((object) => {
    // pages disable raycasting by removing the method
    if (typeof object.raycast !== 'function') return;
    const { geometry } = object as Partial<Mesh>;
    if (geometry === undefined || Object.hasOwn(object, 'raycast') || isReadable(geometry)) {
      raycaster.intersectObject(object, false, hits);
    } else if (object.layers.test(camera.layers) && !skipped.has(object)) {
      skipped.add(object);
      console.warn(
        `Farol: clicks do not find ${object.type} "${object.name || object.uuid}", whose arrays were freed after upload; select it in the list of objects.`,
      );
    }
  });
  hits.sort((a, b) => a.distance - b.distance);
  return hits[0]?.object ?? null;
}
