import { type GameObject, ModelRenderer, ObjectRenderer } from '@farol/engine';
import { type BufferGeometry, type Matrix4, Mesh } from 'three';

/**
 * Visits every mesh that a GameObject draws itself, without those of its children.
 * @param visit - gets the mesh, null where it is drawn as one of many instances; its geometry, and where it is in the
 * world as of the last drawn frame
 */
export function drawnMeshes(
  object: GameObject,
  visit: (mesh: Mesh | null, geometry: BufferGeometry, matrixWorld: Matrix4) => void,
): void {
  const shape = object.getComponent(ObjectRenderer);
  if (shape?.geometry) visit(shape.three, shape.geometry, object.object3D.matrixWorld);
  const model = object.getComponent(ModelRenderer)?.three;
  model?.traverse((each) => {
    if (each instanceof Mesh) visit(each, each.geometry as BufferGeometry, each.matrixWorld);
  });
}
