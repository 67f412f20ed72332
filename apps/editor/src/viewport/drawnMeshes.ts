import { type GameObject, ModelRenderer, ObjectRenderer } from '@farol/engine';
import { hasReadableVertices } from '@farol/renderer/vertex-data';
import { type BufferGeometry, type Matrix4, Mesh } from 'three';

type Visit = (mesh: Mesh | null, geometry: BufferGeometry, matrixWorld: Matrix4) => void;

/**
 * Visits every mesh that a GameObject draws itself, without its children.
 * @param visit - receives the mesh (null for one of many instances), its geometry, and its world matrix as of the last
 *   drawn frame
 */
export function drawnMeshes(object: GameObject, visit: Visit): void {
  const shape = object.getComponent(ObjectRenderer);
  if (shape?.geometry) visit(shape.three, shape.geometry, object.object3D.matrixWorld);
  const model = object.getComponent(ModelRenderer)?.three;
  model?.traverse((each) => {
    if (each instanceof Mesh) visit(each, each.geometry as BufferGeometry, each.matrixWorld);
  });
}

/** Like `drawnMeshes`, but skips meshes whose vertices are only on the GPU. */
export function readableMeshes(object: GameObject, visit: Visit): void {
  drawnMeshes(object, (mesh, geometry, matrixWorld) => {
    if (hasReadableVertices(geometry)) visit(mesh, geometry, matrixWorld);
  });
}
