import { type Material, Mesh, type Object3D } from 'three';
import { GameObject } from '../core/GameObject';
import { ObjectRenderer } from '../components/ObjectRenderer';
import type { Asset } from './Asset';
import type { AssetLibrary } from './AssetLibrary';

/**
 * Makes GameObjects of a three model, such as `gltf.scene`: its tree, transforms and meshes. Geometries and materials
 * are registered with the library as `prefix/name`, and named by the ObjectRenderers. Skeletons, morph targets, lights
 * and cameras are left out; the model itself is left as it is.
 * @param prefix - a name that no assets begin with yet, such as the file's
 * @throws AssetError when the prefix is in use
 */
export function importModel(model: Object3D, assets: AssetLibrary, prefix: string): GameObject {
  const names = new Map<Asset, string>();
  const nameOf = (asset: Asset, kind: string): string => {
    let name = names.get(asset);
    if (name) return name;
    name = `${prefix}/${kind}-${names.size + 1}${asset.name ? `-${asset.name}` : ''}`;
    assets.register(name, asset);
    names.set(asset, name);
    return name;
  };
  const convert = (source: Object3D): GameObject => {
    const gameObject = new GameObject(source.name || source.type);
    const { transform } = gameObject;
    transform.position = source.position.toArray();
    transform.setQuaternion(source.quaternion);
    transform.scale = source.scale.toArray();
    gameObject.active = source.visible;
    if (source instanceof Mesh) {
      const material: Material = Array.isArray(source.material) ? source.material[0] : source.material;
      const { castShadow, receiveShadow } = source;
      gameObject.addComponent(ObjectRenderer, {
        mesh: nameOf(source.geometry, 'mesh'),
        [assetKey(material)]: nameOf(material, 'material'),
        castShadow,
        receiveShadow,
      });
    }
    for (const child of source.children) gameObject.add(convert(child));
    return gameObject;
  };
  return convert(model);
}

const assetKey = (material: Material): 'shader' | 'material' =>
  'isShaderMaterial' in material ? 'shader' : 'material';
