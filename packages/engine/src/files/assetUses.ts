import type { AssetType, FieldValue } from '@farol/editing/fields';
import { fieldAssetFields, isFieldAssetType } from '../assets/fieldAssetTypes';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { sceneFields } from '../settings/SceneSettings';
import { assetFields, type NamedAssetField } from '../fields/assetFields';
import type { FarolFile, FileObject } from './FarolFile';

/** A position in a scene file that names an asset. */
export interface AssetUse {
  readonly path: string;
  readonly type: AssetType;
  readonly name: string;
}

/** A use whose path, for messages, is formatted on demand: a large scene has thousands of uses. */
class Use implements AssetUse {
  constructor(
    readonly type: AssetType,
    readonly name: string,
    private readonly field: string,
    private readonly pathOf: () => string,
  ) {}

  get path(): string {
    return `${this.pathOf()}.${this.field}`;
  }
}

function usesIn(
  values: Readonly<Record<string, FieldValue>>,
  fields: readonly NamedAssetField[],
  pathOf: () => string,
  list: AssetUse[],
): void {
  for (const { name, assetType, default: usual } of fields) {
    const value = Object.hasOwn(values, name) ? values[name] : usual;
    if (typeof value === 'string') list.push(new Use(assetType, value, name, pathOf));
  }
}

/** Every position in a checked file that names an asset, including default values. */
export function assetUses(file: FarolFile, registry: ComponentRegistry): AssetUse[] {
  const list: AssetUse[] = [];
  usesIn(file.settings, assetFields(sceneFields), () => 'settings', list);
  file.assets.forEach(({ type, values }, i) => {
    if (values && isFieldAssetType(type))
      usesIn(values, assetFields(fieldAssetFields[type]), () => `assets[${i}].values`, list);
  });
  const visit = (objects: readonly FileObject[], path: string): void =>
    objects.forEach((object, i) => {
      object.components.forEach(({ type, values }, j) => {
        const fields = assetFields(registry.fieldsOf(type));
        if (fields.length > 0) usesIn(values, fields, () => `${path}[${i}].components[${j}].values`, list);
      });
    });
  visit(file.objects, 'objects');
  file.prefabs?.forEach(({ objects }, i) => visit(objects, `prefabs[${i}].objects`));
  return list;
}
