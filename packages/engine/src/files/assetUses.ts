import { fieldAssetFields, isFieldAssetType } from '../assets/fieldAssetTypes';
import type { ComponentRegistry } from '../core/SceneGraph';
import { sceneFields } from '../core/SceneSettings';
import { assetFields } from '../fields/assetFields';
import type { AssetType, FieldTable, FieldValue } from '../fields/Field';
import type { FarolFile, FileObject } from './FarolFile';

/** A place in a file that names an asset. */
export interface AssetUse {
  readonly path: string;
  readonly type: AssetType;
  readonly name: string;
}

function usesIn(
  values: Readonly<Record<string, FieldValue>>,
  fields: FieldTable,
  pathOf: () => string,
  list: AssetUse[],
): void {
  for (const { name, assetType, default: usual } of assetFields(fields)) {
    const value = Object.hasOwn(values, name) ? values[name] : usual;
    if (typeof value === 'string') list.push({ path: `${pathOf()}.${name}`, type: assetType, name: value });
  }
}

/** Every place of a checked file that names an asset, defaults included. */
export function assetUses(file: FarolFile, registry: ComponentRegistry): AssetUse[] {
  const list: AssetUse[] = [];
  usesIn(file.settings, sceneFields, () => 'settings', list);
  file.assets.forEach(({ type, values }, i) => {
    if (values && isFieldAssetType(type)) usesIn(values, fieldAssetFields[type], () => `assets[${i}].values`, list);
  });
  const visit = (objects: readonly FileObject[], path: string): void =>
    objects.forEach((object, i) => {
      object.components.forEach(({ type, values }, j) => {
        usesIn(values, registry.fieldsOf(type), () => `${path}[${i}].components[${j}].values`, list);
      });
    });
  visit(file.objects, 'objects');
  file.prefabs?.forEach(({ objects }, i) => visit(objects, `prefabs[${i}].objects`));
  return list;
}
