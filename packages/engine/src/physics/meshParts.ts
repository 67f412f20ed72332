import { type BufferGeometry, Matrix4, Mesh, type Object3D } from 'three';
import { Model } from '../assets/Model';
import { isDrawnBy, isOfSubtree, type ModelSubtree, subtreeOf } from '../assets/modelNodes';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';

export interface MeshPart {
  readonly geometry: BufferGeometry;
  /** Matrix from the mesh's local space to the GameObject's. */
  readonly matrix: Matrix4;
}

/** A mesh or model that an object is drawn with, by its name in the library. */
export interface MeshName {
  readonly type: 'mesh' | 'model';
  readonly name: string;
  /** Parts of the model, in the form of `subtreeOf`. */
  readonly parts: string;
}

/** Meshes that an object's own enabled renderers draw. */
export function meshNamesOf(object: GameObject): MeshName[] {
  const names: MeshName[] = [];
  for (const component of object.components) {
    if (!component.enabled) continue;
    const { typeName } = component;
    if (typeName !== 'ObjectRenderer' && typeName !== 'ModelRenderer') continue;
    const type = typeName === 'ObjectRenderer' ? 'mesh' : 'model';
    const name = component.get(type);
    if (typeof name === 'string')
      names.push({ type, name, parts: type === 'model' ? (component.get('parts') as string) : '' });
  }
  return names;
}

/**
 * Objects whose meshes a collider is fitted to: its own object if that draws a mesh, else all descendants, except ones
 * that belong to another body.
 */
export function drawnObjects(object: GameObject): GameObject[] {
  if (meshNamesOf(object).length > 0) return [object];
  return object.children.flatMap((child) => (child.getComponent('RigidBody') ? [] : drawnObjects(child)));
}

/** @param subtree - drawn part of the model; the object is at its root */
function addModelParts(node: Object3D, matrix: Matrix4, parts: MeshPart[], subtree: ModelSubtree | null): void {
  node.updateMatrix();
  const own = node === subtree?.root ? matrix : new Matrix4().multiplyMatrices(matrix, node.matrix);
  const isDrawn = !subtree || isDrawnBy(node, subtree);
  if (isDrawn && node instanceof Mesh) parts.push({ geometry: node.geometry as BufferGeometry, matrix: own });
  for (const child of node.children) {
    if (!subtree || isOfSubtree(child, subtree)) addModelParts(child, own, parts, subtree);
  }
}

/** Matrix from an object's space to that of its ancestor `above`. */
function matrixBetween(object: GameObject, above: GameObject): Matrix4 {
  const matrix = new Matrix4();
  for (let each: GameObject | null = object; each && each !== above; each = each.parent) {
    each.object3D.updateMatrix();
    matrix.premultiply(each.object3D.matrix);
  }
  return matrix;
}

/** Loaded meshes that a collider of an object is fitted to. */
export function meshParts(object: GameObject, scene: Scene): MeshPart[] {
  const parts: MeshPart[] = [];
  for (const drawn of drawnObjects(object)) {
    const matrix = matrixBetween(drawn, object);
    for (const { type, name, parts: named } of meshNamesOf(drawn)) {
      if (!scene.assets.isReady(type, name)) continue;
      const asset = scene.assets.get(name);
      if (asset instanceof Model) {
        const subtree = subtreeOf(asset.scene, named);
        addModelParts(subtree?.root ?? asset.scene, matrix, parts, subtree);
      } else parts.push({ geometry: asset as BufferGeometry, matrix });
    }
  }
  return parts;
}

/** Resolves when all meshes that colliders of a scene need are loaded, or have failed. */
export async function shapesReady(scene: Scene): Promise<void> {
  const names = new Set<string>();
  for (const collider of scene.componentsOf('Collider')) {
    for (const object of drawnObjects(collider.gameObject)) {
      for (const { type, name } of meshNamesOf(object)) if (!scene.assets.isReady(type, name)) names.add(name);
    }
  }
  await Promise.allSettled([...names].map((name) => scene.assets.load(name)));
}
