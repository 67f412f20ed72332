import type { AssetKind } from './assetKinds';

/** What is dragged from the Assets panel. */
export interface DraggedAsset {
  readonly kind: AssetKind;
  /** Name of the asset, id of the prefab. */
  readonly name: string;
  /** All that is dragged with it, itself included; itself alone when absent. */
  readonly names?: readonly string[];
}

const TYPE = 'application/x-farol-asset';

/** Types can be read while something is dragged, what they hold only when it is dropped: the kind is in the type. */
const typeOf = (kind: AssetKind): string => `${TYPE}-${kind}`;

/** Begins a drag. @param names - of all that are dragged with the asset, itself included */
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

/** Whether an asset is dragged, of this kind if one is given. */
export const isAssetDrag = (transfer: DataTransfer, kind?: AssetKind): boolean =>
  transfer.types.includes(kind ? typeOf(kind) : TYPE);

/** Whether files are dragged from outside. */
export const isFileDrag = (transfer: DataTransfer): boolean => transfer.types.includes('Files');

const isText = (value: unknown): value is string => typeof value === 'string';

/** The asset that is dropped; null when it is none of the editor's: any page can have its own dragged under that type. */
export function draggedAsset(transfer: DataTransfer): DraggedAsset | null {
  try {
    const asset = JSON.parse(transfer.getData(TYPE)) as DraggedAsset;
    const { kind, name, names = [] } = asset;
    return isText(kind) && isText(name) && names.every(isText) ? asset : null;
  } catch {
    return null;
  }
}
