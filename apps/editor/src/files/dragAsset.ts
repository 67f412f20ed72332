import type { AssetKind } from './assetKinds';

export interface DraggedAsset {
  readonly kind: AssetKind | 'library';
  /** Name of the asset, or id of the prefab or of the library's item. */
  readonly name: string;
  /** Names of all dragged assets, including this one; only this one when absent. */
  readonly names?: readonly string[];
}

const TYPE = 'application/x-farol-asset';

/** During a drag only types can be read, not data: so the type contains the asset's kind. */
const typeOf = (kind: DraggedAsset['kind']): string => `${TYPE}-${kind}`;

/** Starts a drag. @param names - names of all dragged assets, including this one */
export function setDraggedAsset(
  transfer: DataTransfer,
  { kind, name }: DraggedAsset,
  names: readonly string[] = [name],
): void {
  const asset: DraggedAsset = { kind, name, names };
  transfer.setData(TYPE, JSON.stringify(asset));
  transfer.setData(typeOf(asset.kind), asset.name);
  transfer.setData('text/plain', asset.name);
  transfer.effectAllowed = 'copy';
}

/** Whether an asset is dragged, optionally of a given kind. */
export const isAssetDrag = (transfer: DataTransfer, kind?: AssetKind): boolean =>
  transfer.types.includes(kind ? typeOf(kind) : TYPE);

/** Whether files are dragged from outside. */
export const isFileDrag = (transfer: DataTransfer): boolean => transfer.types.includes('Files');

const isText = (value: unknown): value is string => typeof value === 'string';

/** The dropped asset; null when the data is malformed, since other pages can use the same type. */
export function draggedAsset(transfer: DataTransfer): DraggedAsset | null {
  try {
    const asset = JSON.parse(transfer.getData(TYPE)) as DraggedAsset;
    const { kind, name, names = [] } = asset;
    return isText(kind) && isText(name) && names.every(isText) ? asset : null;
  } catch {
    return null;
  }
}
