import type { GameObject } from '@farol/engine';
import { Box3, SkinnedMesh, Vector3 } from 'three';
import { readableMeshes } from './drawnMeshes';

const part = new Box3();
const place = new Vector3();

/** Adds the bounds of an object's own meshes; its position when it has none. */
function expandByObject(target: Box3, object: GameObject): void {
  let isDrawn = false;
  readableMeshes(object, (mesh, geometry, matrixWorld) => {
    isDrawn = true;
    if (mesh instanceof SkinnedMesh) {
      // bounds of a skinned mesh are those of its current pose
      mesh.computeBoundingBox();
      part.copy(mesh.boundingBox!);
    } else {
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      part.copy(geometry.boundingBox!);
    }
    target.union(part.applyMatrix4(matrixWorld));
  });
  if (isDrawn) return;
  if (object.components.length > 1 || object.children.length === 0) {
    target.expandByPoint(place.setFromMatrixPosition(object.object3D.matrixWorld));
  }
}

/**
 * World bounds of GameObjects, as of the last drawn frame. Objects without a mesh, such as lights, count as points.
 * @param isDeep - whether their descendants are included
 */
export function boundsOf(objects: readonly GameObject[], target = new Box3(), isDeep = true): Box3 {
  target.makeEmpty();
  const visit = (object: GameObject): void => {
    expandByObject(target, object);
    if (isDeep) object.children.forEach(visit);
  };
  objects.forEach(visit);
  return target;
}
