import { type ReactNode, useEffect, useRef, useState } from 'react';
import type { AssetEntry, AssetKind } from '../files/assetKinds';
import type { IconName } from '../style/iconPaths';
import { Icon } from './Icon';
import { useThumbnail } from './useThumbnail';

/** The icon of each kind of asset. */
export const assetIcons: Readonly<Record<AssetKind, IconName>> = {
  prefab: 'prefab',
  model: 'mesh',
  mesh: 'mesh',
  texture: 'scene',
  material: 'contrast',
  shader: 'contrast',
  script: 'code',
  clip: 'motion',
  sound: 'sound',
  profile: 'spot',
  surface: 'code',
  bake: 'lamp',
};

/** A small picture of an asset, drawn once it comes into sight; an icon until then. */
export function Thumbnail({ entry, size = 28 }: { entry: AssetEntry; size?: number }): ReactNode {
  const place = useRef<HTMLSpanElement>(null);
  const [inSight, setInSight] = useState(false);
  useEffect(() => {
    const observer = new IntersectionObserver(([first]) => first.isIntersecting && setInSight(true));
    // the card, since what is within it may be left out of the layout as long as it is out of sight
    observer.observe(place.current!.parentElement!);
    return () => observer.disconnect();
  }, []);
  const picture = useThumbnail(entry, inSight);
  return (
    <span ref={place} className="asset-picture">
      {picture ? <img src={picture} alt="" draggable={false} /> : <Icon name={assetIcons[entry.kind]} size={size} />}
    </span>
  );
}
