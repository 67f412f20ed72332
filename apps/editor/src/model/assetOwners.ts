import { t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';

/** An object with fields that may refer to assets. */
export interface AssetOwner {
  readonly owner: FieldOwner;
  /** Name of the owner for the user: 'Robot', 'Scene', or a material's name. */
  readonly place: string;
  /** Id of the object when the owner is a component. */
  readonly object?: string;
}

/** Everything in a scene whose fields may refer to assets: settings, components and assets made of fields. */
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
