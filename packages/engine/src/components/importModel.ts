import { type Material, Mesh, type Object3D } from 'three';
import { GameObject } from '../core/GameObject';
import type { AssetLibrary } from '../assets/AssetLibrary';
import { Model } from '../assets/Model';
import { modelParts } from '../assets/modelParts';
import { ObjectRenderer } from './ObjectRenderer';

/** A GameObject with name, pose and visibility of a three object. */
export function objectLike(object: Object3D): GameObject {
  const gameObject = new GameObject(object.name || object.type);
  const { transform } = gameObject;
  transform.position = object.position.toArray();
  transform.setQuaternion(object.quaternion);
  transform.scale = object.scale.toArray();
  gameObject.active = object.visible;
  return gameObject;
}

/**
 * Makes GameObjects of a three model, such as `gltf.scene`: its tree, transforms and meshes, so that each can be
 * edited. The ObjectRenderers refer to geometries and materials by the library's names of the model's parts; missing
 * ones are registered. Skeletons, morph targets, lights and cameras are left out: a ModelRenderer keeps them. The model
 * itself is not changed.
 * @param prefix - name of the model in the library, or a new one
 * @throws AssetError when other assets have the prefix
 */
export function importModel(model: Object3D | Model, assets: AssetLibrary, prefix: string): GameObject {
  const source = model instanceof Model ? model : new Model(model);
  const names = modelParts(source, prefix);
  for (const [asset, name] of names) {
    if (!assets.has(name) || assets.get(name) !== asset) assets.register(name, asset);
  }
  const convert = (object: Object3D): GameObject => {
    const gameObject = objectLike(object);
    if (object instanceof Mesh) {
      const material: Material = Array.isArray(object.material) ? object.material[0] : object.material;
      const { castShadow, receiveShadow } = object;
      gameObject.addComponent(ObjectRenderer, {
        mesh: names.get(object.geometry) ?? null,
        ['isShaderMaterial' in material ? 'shader' : 'material']: names.get(material) ?? null,
        castShadow,
        receiveShadow,
      });
    }
    for (const child of object.children) gameObject.add(convert(child));
    return gameObject;
  };
  return convert(source.scene);
}
