import { t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';

/** Something whose fields may name assets. */
export interface AssetOwner {
  readonly owner: FieldOwner;
  /** What it is of: 'Robot', 'Scene', the name of a material. */
  readonly place: string;
  /** Of a component: the id of its object. */
  readonly object?: string;
}

/** All of a scene whose fields may name assets: its settings, components and assets made of fields. */
export function assetOwners(scene: Scene): AssetOwner[] {
  const owners: AssetOwner[] = [{ owner: scene.settings, place: t('Scene') }];
  for (const asset of scene.assets.fieldAssets()) owners.push({ owner: asset, place: asset.name });
  scene.traverse((object) => {
    for (const component of object.components) {
      owners.push({ owner: component, place: object.name, object: object.id });
    }
  });
  return owners;
}
