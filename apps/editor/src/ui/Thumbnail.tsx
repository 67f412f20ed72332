import { type ReactNode, useEffect, useRef, useState } from 'react';
import type { AssetEntry, AssetKind } from '../files/assetKinds';
import type { IconName } from '../style/iconPaths';
import { Icon } from './Icon';
import { useThumbnail } from './useThumbnail';

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

/** Thumbnail of an asset, rendered once visible; an icon until then. */
export function Thumbnail({ entry, size = 28 }: { entry: AssetEntry; size?: number }): ReactNode {
  const place = useRef<HTMLSpanElement>(null);
  const [inSight, setInSight] = useState(false);
  useEffect(() => {
    const observer = new IntersectionObserver(([first]) => first.isIntersecting && setInSight(true));
    // observes the card: content inside may be skipped by the layout while it is off-screen
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
