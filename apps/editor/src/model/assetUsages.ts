import { type Command, type FieldEdit, SetFields, t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { AssetType, FieldTable, FieldValue } from '@farol/engine/fields';
import type { Prefab } from '@farol/engine/prefabs';
import { type AssetOwner, assetOwners } from './assetOwners';
import { RemoveAsset } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';
import { SetPrefab } from './commands/SetPrefab';
import { componentTypeOf } from './scriptNames';

export interface AssetUsage {
  /** Name of the owner that uses the asset: 'Robot', 'Scene', 'Lamp (prefab)'. */
  readonly place: string;
  /** Component and field that refer to the asset: 'ModelRenderer.model'. */
  readonly field: string;
  /** Id of the object when an object uses the asset. */
  readonly object?: string;
}

const isOne = (names: ReadonlySet<string>, value: FieldValue | undefined): boolean =>
  typeof value === 'string' && names.has(value);

function editsOf(scene: Scene, names: ReadonlySet<string>): (FieldEdit & AssetOwner)[] {
  return assetOwners(scene).flatMap((each) =>
    Object.entries(each.owner.fields).flatMap(([name, field]) =>
      field.kind === 'asset' && field.viewOf === undefined && isOne(names, each.owner.getAuthored(name))
        ? [{ ...each, name, value: null }]
        : [],
    ),
  );
}

const assetFields = (fields: FieldTable): [string, AssetType][] =>
  Object.entries(fields).flatMap(
    ([name, field]) => (field.kind === 'asset' ? [[name, field.assetType] as const] : []) as [string, AssetType][],
  );

/** A prefab without references to assets of these names, and the places that had such a reference. */
function without(scene: Scene, prefab: Prefab, names: ReadonlySet<string>): { next: Prefab; usages: AssetUsage[] } {
  const usages: AssetUsage[] = [];
  const objects = prefab.objects.map((object) => ({
    ...object,
    components: object.components.map((component) => {
      const values = { ...component.values };
      for (const [name] of assetFields(scene.registry.fieldsOf(component.type))) {
        if (!isOne(names, values[name])) continue;
        values[name] = null;
        usages.push({
          place: t('{name} (prefab {prefab})', { name: object.name, prefab: prefab.name }),
          field: `${component.type}.${name}`,
        });
      }
      return { ...component, values };
    }),
  }));
  return { next: { ...prefab, objects }, usages };
}

const withParts = (scene: Scene, asset: string): Set<string> => new Set([asset, ...scene.assets.partsOf(asset)]);

/** Places that have a component of a script. */
function usagesOfScript(scene: Scene, script: string, source: string): AssetUsage[] {
  const type = componentTypeOf(script, source);
  const usages: AssetUsage[] = [];
  if (type === null) return usages;
  scene.traverse(({ components, name, id }) => {
    for (const { typeName } of components) if (typeName === type) usages.push({ place: name, field: type, object: id });
  });
  for (const prefab of scene.prefabs.list) {
    for (const object of prefab.objects) {
      const place = t('{name} (prefab {prefab})', { name: object.name, prefab: prefab.name });
      if (object.components.some((each) => each.type === type)) usages.push({ place, field: type });
    }
  }
  return usages;
}

/** Every place that refers to an asset or a part of it, or, for a script, has a component that it defines. */
export function usagesOf(scene: Scene, asset: string): AssetUsage[] {
  const script = scene.assets.fieldAsset(asset);
  if (script?.type === 'script') return usagesOfScript(scene, asset, script.get('source') as string);
  const names = withParts(scene, asset);
  return [
    ...editsOf(scene, names).map(({ owner, name, place, object }) => ({
      place,
      field: 'typeName' in owner ? `${owner.ownerName}.${name}` : name,
      ...(object === undefined ? {} : { object }),
    })),
    ...scene.prefabs.list.flatMap((prefab) => without(scene, prefab, names).usages),
  ];
}

/** Deletes an asset; fields that referred to it become empty. */
export function deleteAsset(scene: Scene, asset: string): Command {
  const names = withParts(scene, asset);
  const edits = editsOf(scene, names);
  const prefabs = scene.prefabs.list.flatMap((prefab) => {
    const { next, usages } = without(scene, prefab, names);
    return usages.length > 0 ? [next] : [];
  });
  return new Sequence(t('Deleted {asset}', { asset }), [
    ...prefabs.map((prefab) => () => new SetPrefab(scene, prefab.id, prefab)),
    ...(edits.length > 0 ? [() => new SetFields('Clear', edits)] : []),
    () => new RemoveAsset(scene.assets, asset),
  ]);
}
