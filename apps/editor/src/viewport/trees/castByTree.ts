import type { MeshCaster } from '@farol/engine';
import { InstancedMesh, type Intersection, Matrix4, Mesh, type Raycaster, Sphere } from 'three';
import { LARGE, treeOf } from './meshTrees';

const sphere = new Sphere();
const instance = new Mesh();
const found: Intersection[] = [];
const matrix = new Matrix4();

/** Whether the vertices of a mesh are where its geometry has them: no bones, morph targets or batches. */
export const isRigid = (mesh: Mesh): boolean =>
  !('isSkinnedMesh' in mesh) && !('isBatchedMesh' in mesh) && (mesh.morphTargetInfluences?.length ?? 0) === 0;

function isNear({ geometry }: Mesh, world: Matrix4, { ray }: Raycaster): boolean {
  if (!geometry.boundingSphere) geometry.computeBoundingSphere();
  return ray.intersectsSphere(sphere.copy(geometry.boundingSphere!).applyMatrix4(world));
}

function castInstances(mesh: InstancedMesh, raycaster: Raycaster, hits: Intersection[]): boolean {
  const { geometry, material, count } = mesh;
  for (let i = 0; i < count; i++) {
    mesh.getMatrixAt(i, matrix);
    instance.matrixWorld.multiplyMatrices(mesh.matrixWorld, matrix);
    instance.geometry = geometry;
    instance.material = material;
    if (!isNear(instance, instance.matrixWorld, raycaster)) continue;
    const tree = treeOf(geometry);
    if (!tree) return false;
    tree.raycastObject3D(instance, raycaster, found);
    for (const hit of found) hits.push(Object.assign(hit, { object: mesh, instanceId: i }));
    found.length = 0;
  }
  return true;
}

/** Raycasts a large mesh by its bounding volume hierarchy; a mesh without a hierarchy is left to three's raycast. */
export const castByTree: MeshCaster = (mesh, raycaster, hits) => {
  const { geometry } = mesh;
  const { index, attributes } = geometry;
  if ((index ?? attributes.position)?.count <= 3 * LARGE || !isRigid(mesh)) return false;
  if (mesh instanceof InstancedMesh) return castInstances(mesh, raycaster, hits);
  if (!isNear(mesh, mesh.matrixWorld, raycaster)) return true;
  const tree = treeOf(geometry);
  tree?.raycastObject3D(mesh, raycaster, hits);
  return tree !== null;
};

/** Adds a ray's hits on a mesh. */
export function castMesh(mesh: Mesh, raycaster: Raycaster, hits: Intersection[]): void {
  if (!castByTree(mesh, raycaster, hits)) raycaster.intersectObject(mesh, false, hits);
}
