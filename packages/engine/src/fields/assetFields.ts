import type { AssetType, FieldTable } from '@farol/editing/fields';

/** A field that names an asset. */
export interface NamedAssetField {
  readonly name: string;
  readonly assetType: AssetType;
  readonly default: string | null;
}

const known = new WeakMap<FieldTable, readonly NamedAssetField[]>();

/** The fields of a table that name assets; cached, since scenes have many components of few types. */
export function assetFields(fields: FieldTable): readonly NamedAssetField[] {
  let list = known.get(fields);
  if (!list) {
    list = Object.entries(fields).flatMap(([name, field]) =>
      field.kind === 'asset' && field.viewOf === undefined
        ? [{ name, assetType: field.assetType, default: field.default }]
        : [],
    );
    known.set(fields, list);
  }
  return list;
}
