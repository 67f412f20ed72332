import { type ReactNode, useEffect, useRef, useState } from 'react';
import { setDraggedAsset } from '../../files/dragAsset';
import type { AssetEntry, AssetKind } from '../../files/assetKinds';
import type { ThumbnailMaker } from '../../files/ThumbnailMaker';
import { Icon } from '../../ui/Icon';
import type { IconName } from '../../style/iconPaths';

const icons: Readonly<Record<AssetKind, IconName>> = {
  prefab: 'prefab',
  model: 'mesh',
  mesh: 'mesh',
  texture: 'scene',
  material: 'contrast',
  shader: 'contrast',
};

interface AssetCardProps {
  /** Another one each time the asset may look otherwise. */
  readonly entry: AssetEntry;
  readonly maker: ThumbnailMaker;
  readonly selected: boolean;
  onSelect(): void;
  onPlace(): void;
}

/** One asset: picture and name; dragged into the scene, or placed by a double click or Enter. */
export function AssetCard({ entry, maker, selected, onSelect, onPlace }: AssetCardProps): ReactNode {
  const card = useRef<HTMLButtonElement>(null);
  const [inSight, setInSight] = useState(false);
  const [picture, setPicture] = useState<string | null>(null);
  useEffect(() => {
    const observer = new IntersectionObserver(([first]) => first.isIntersecting && setInSight(true));
    observer.observe(card.current!);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    if (!inSight) return;
    let isWanted = true;
    void maker.pictureOf(entry).then((address) => isWanted && address && setPicture(address));
    return () => {
      isWanted = false;
    };
  }, [entry, inSight, maker]);
  return (
    <button
      ref={card}
      type="button"
      className="asset-card"
      title={`${entry.label} (${entry.kind})`}
      aria-pressed={selected}
      draggable
      data-asset={entry.name}
      onDragStart={(event) => setDraggedAsset(event.dataTransfer, entry)}
      onClick={onSelect}
      onFocus={onSelect}
      onDoubleClick={onPlace}
      onKeyDown={(event) => {
        if (event.key !== 'Enter') return;
        event.preventDefault();
        onPlace();
      }}
    >
      <span className="asset-picture">
        {picture ? <img src={picture} alt="" draggable={false} /> : <Icon name={icons[entry.kind]} size={28} />}
      </span>
      <span className="asset-name">{entry.label}</span>
    </button>
  );
}
