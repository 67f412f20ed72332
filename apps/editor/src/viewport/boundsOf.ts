import { type GameObject, ObjectRenderer } from '@farol/engine';
import { Box3, Vector3 } from 'three';

const part = new Box3();
const place = new Vector3();

/**
 * The box in the world round GameObjects and all below them, as of the last drawn frame. What has no mesh, such as a
 * light, counts as its place.
 */
export function boundsOf(objects: readonly GameObject[], target = new Box3()): Box3 {
  target.makeEmpty();
  const visit = (object: GameObject): void => {
    const geometry = object.getComponent(ObjectRenderer)?.geometry;
    const { matrixWorld } = object.object3D;
    if (geometry) {
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      target.union(part.copy(geometry.boundingBox!).applyMatrix4(matrixWorld));
    } else if (object.components.length > 1 || object.children.length === 0) {
      target.expandByPoint(place.setFromMatrixPosition(matrixWorld));
    }
    object.children.forEach(visit);
  };
  objects.forEach(visit);
  return target;
}
