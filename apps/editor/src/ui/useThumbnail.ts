import { useEffect, useState, useSyncExternalStore } from 'react';
import type { AssetEntry } from '../files/assetKinds';
import { useEditor } from './EditorContext';

/** Delay after a material's last change before its thumbnail is rendered again (ms). */
const CALM = 250;

const never = (): (() => void) => () => {};

/**
 * URL of an asset's thumbnail; null until there is one. Thumbnails of materials are updated when fields change.
 * @param entry - a new object each time the asset may look different
 * @param isWanted - whether the thumbnail is needed now
 */
export function useThumbnail(entry: AssetEntry, isWanted: boolean): string | null {
  const editor = useEditor();
  const { document } = editor;
  const [picture, setPicture] = useState<string | null>(null);
  const material = entry.kind === 'material' ? document.assets.materialAsset(entry.name) : null;
  const signal = material ? document.ownerSignal(material) : null;
  const revision = useSyncExternalStore(signal?.subscribe ?? never, () => signal?.revision ?? 0);
  useEffect(() => {
    if (!isWanted) return;
    let isCurrent = true;
    const draw = async (): Promise<void> => {
      // offline the code may be missing: an icon is shown instead
      const code = await import('../files/thumbnails').catch(() => null);
      if (!isCurrent || !code) return;
      const address = await code.thumbnailsOf(editor).pictureOf(entry);
      if (isCurrent && address) setPicture(address);
    };
    const timer = setTimeout(() => void draw(), revision > 0 ? CALM : 0);
    return () => {
      isCurrent = false;
      clearTimeout(timer);
    };
  }, [editor, entry, isWanted, revision]);
  return picture;
}
