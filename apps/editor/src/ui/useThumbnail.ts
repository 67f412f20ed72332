import { useEffect, useState, useSyncExternalStore } from 'react';
import type { AssetEntry } from '../files/assetKinds';
import { useEditor } from './EditorContext';

/** Milliseconds that a material stays as it is before its picture is drawn anew. */
const CALM = 250;

const never = (): (() => void) => () => {};

/**
 * The address of a small picture of an asset; null until there is one. That of a material follows its fields.
 * @param entry - another one each time the asset may look otherwise
 * @param isWanted - whether it is to be drawn now
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
      // without its code, such as without a network, an asset has its sign in place of a picture
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
