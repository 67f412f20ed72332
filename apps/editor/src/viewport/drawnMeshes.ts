import { type GameObject, ModelRenderer, ObjectRenderer } from '@farol/engine';
import { hasReadableVertices } from '@farol/renderer/vertex-data';
import { type BufferGeometry, type Matrix4, Mesh } from 'three';

type Visit = (mesh: Mesh | null, geometry: BufferGeometry, matrixWorld: Matrix4) => void;

/**
 * Visits every mesh that a GameObject draws itself, without those of its children.
 * @param visit - gets the mesh, null where it is drawn as one of many instances; its geometry, and where it is in the
 * world as of the last drawn frame
 */
export function drawnMeshes(object: GameObject, visit: Visit): void {
  const shape = object.getComponent(ObjectRenderer);
  if (shape?.geometry) visit(shape.three, shape.geometry, object.object3D.matrixWorld);
  const model = object.getComponent(ModelRenderer)?.three;
  model?.traverse((each) => {
    if (each instanceof Mesh) visit(each, each.geometry as BufferGeometry, each.matrixWorld);
  });
}

/** Visits as `drawnMeshes` does, but not those whose vertices the GPU alone has. */
export function readableMeshes(object: GameObject, visit: Visit): void {
  drawnMeshes(object, (mesh, geometry, matrixWorld) => {
    if (hasReadableVertices(geometry)) visit(mesh, geometry, matrixWorld);
  });
}
