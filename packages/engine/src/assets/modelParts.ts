import type { BufferGeometry, Material, Texture } from 'three';
import { type Asset, assetTypeOf } from './Asset';
import { type Model, texturesOf } from './Model';

/**
 * Names the meshes, materials, textures, clips and profiles of a model that can be used separately, each once:
 * 'robot.glb/mesh-1-Head'. Equal files give equal names.
 * @param prefix - name of the model
 */
export function modelParts(model: Model, prefix: string): Map<Asset, string> {
  const names = new Map<Asset, string>();
  const counts = new Map<string, number>();
  const add = (asset: Asset): void => {
    if (names.has(asset)) return;
    const type = assetTypeOf(asset);
    const count = (counts.get(type) ?? 0) + 1;
    counts.set(type, count);
    names.set(asset, `${prefix}/${type}-${count}${asset.name ? `-${asset.name}` : ''}`);
  };
  model.scene.traverse((object) => {
    const { geometry, material } = object as { geometry?: BufferGeometry; material?: Material | Material[] };
    if (!('isMesh' in object)) return;
    if (geometry) add(geometry);
    for (const each of material === undefined ? [] : [material].flat()) {
      add(each);
      for (const texture of texturesOf(each) as Texture[]) add(texture);
    }
  });
  for (const clip of model.clips) add(clip);
  for (const profile of model.profiles) add(profile);
  return names;
}
