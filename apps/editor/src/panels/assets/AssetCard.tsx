import { type KeyboardEvent, type MouseEvent, memo, type ReactNode } from 'react';
import { setDraggedAsset } from '../../files/dragAsset';
import { type AssetEntry, kindLabel } from '../../files/assetKinds';
import { Thumbnail } from '../../ui/Thumbnail';

interface AssetCardProps {
  /** Data of the asset; a new object whenever the card may look different. */
  readonly entry: AssetEntry;
  readonly selected: boolean;
  /** Names of all selected assets, which are dragged together. */
  readonly dragged: readonly string[];
  onSelect(entry: AssetEntry, isAdded: boolean): void;
  onPlace(entry: AssetEntry): void;
}

/**
 * Card of an asset, with picture and name. It can be dragged into the scene, a field or a folder, or placed by a double
 * click or Enter.
 */
export const AssetCard = memo(function AssetCard(props: AssetCardProps): ReactNode {
  const { entry, selected, dragged, onSelect, onPlace } = props;
  const place = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    onPlace(entry);
  };
  const select = (event: MouseEvent): void => onSelect(entry, event.ctrlKey || event.metaKey || event.shiftKey);
  return (
    <button
      type="button"
      className="asset-card"
      title={`${entry.label} (${kindLabel(entry.kind)})`}
      aria-pressed={selected}
      draggable
      data-asset={entry.name}
      onDragStart={(event) => setDraggedAsset(event.dataTransfer, entry, selected ? dragged : [entry.name])}
      onClick={select}
      onDoubleClick={() => onPlace(entry)}
      onKeyDown={place}
    >
      <Thumbnail entry={entry} />
      <span className="asset-name one-line">{entry.label}</span>
    </button>
  );
});
