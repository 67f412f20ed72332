import { type AssetLibrary, type GameObject, ModelRenderer, ObjectRenderer, shapeOf, subtreeOf } from '@farol/engine';
import { Box3, type BufferGeometry } from 'three';

const part = new Box3();

/** Local bounds of an object's own meshes; empty until their assets are loaded. */
function drawnBoxOf(assets: AssetLibrary, object: GameObject): Box3 {
  part.makeEmpty();
  const renderer = object.getComponent(ObjectRenderer);
  const mesh = renderer?.mesh ?? null;
  const made = renderer ? shapeOf(object.components) : null;
  if (made || (mesh !== null && assets.isReady('mesh', mesh))) {
    const geometry = made ?? (assets.get(mesh!) as BufferGeometry);
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    part.copy(geometry.boundingBox!);
  }
  const drawn = object.getComponent(ModelRenderer);
  if (!drawn || drawn.model === null || !assets.isReady('model', drawn.model)) return part;
  const { scene } = assets.model(drawn.model);
  const subtree = subtreeOf(scene, drawn.parts);
  if (!subtree) return part.union(new Box3().setFromObject(scene));
  scene.updateMatrixWorld();
  const box = new Box3();
  for (const node of subtree.nodes) box.expandByObject(node);
  // the box is relative to the root of the model's parts, whose place the object takes
  return part.union(box.applyMatrix4(subtree.root.matrixWorld.clone().invert()));
}

/** World bounds of objects that are not in a scene yet; empty when they draw nothing. */
export function boundsOfNew(objects: readonly GameObject[], assets: AssetLibrary, target = new Box3()): Box3 {
  target.makeEmpty();
  for (const root of objects) {
    root.object3D.updateMatrixWorld(true);
    root.traverse((object) => {
      const shape = drawnBoxOf(assets, object);
      if (!shape.isEmpty()) target.union(shape.applyMatrix4(object.object3D.matrixWorld));
    });
  }
  return target;
}

/** Names of assets that must be loaded to know the size of objects. */
export function shapesToLoad(objects: readonly GameObject[], assets: AssetLibrary): string[] {
  const names = new Set<string>();
  for (const root of objects) {
    root.traverse((object) => {
      const mesh = object.getComponent(ObjectRenderer)?.mesh ?? null;
      const model = object.getComponent(ModelRenderer)?.model ?? null;
      if (mesh !== null && assets.has(mesh, 'mesh') && !assets.isReady('mesh', mesh)) names.add(mesh);
      if (model !== null && assets.has(model, 'model') && !assets.isReady('model', model)) names.add(model);
    });
  }
  return [...names];
}
