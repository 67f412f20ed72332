import { t, tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import type { BufferGeometry, Texture } from 'three';
import type { AssetEntry } from '../../files/assetKinds';
import { useEditor } from '../../ui/EditorContext';
import { ModelInside } from './ModelInside';

const kilobytes = (bytes: number): string =>
  bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`;

/** Facts of an asset: size, triangles, bytes; the contents of a model. */
export function AssetFacts({ entry }: { entry: AssetEntry }): ReactNode {
  const { document } = useEditor();
  const { assets } = document;
  const { kind, name } = entry;
  const facts: string[] = [];
  const file = kind === 'prefab' ? null : assets.fileOf(name);
  if (file) facts.push(kilobytes(file.size));
  if (kind === 'texture' && assets.isReady('texture', name)) {
    const { image, colorSpace } = assets.texture(name) as Texture<{ width?: number; height?: number }>;
    facts.push(t('{width} × {height} texels', { width: image.width ?? 0, height: image.height ?? 0 }));
    facts.push(colorSpace === 'srgb' ? t('sRGB colours; read as data in maps of data') : t('Linear'));
  }
  if (kind === 'mesh' && assets.isReady('mesh', name)) {
    const { index, attributes } = assets.mesh(name) as BufferGeometry;
    facts.push(tCount((index ?? attributes.position).count / 3, '{count} triangle', '{count} triangles'));
  }
  const model = kind === 'prefab' ? null : assets.modelOf(name);
  if (model) facts.push(t('Part of {model}', { model }));
  if (entry.isBuiltin) facts.push(t('Comes with Farol'));
  return (
    <>
      {facts.length > 0 && <p className="asset-note">{facts.join(' · ')}</p>}
      {kind === 'model' && assets.isReady('model', name) && <ModelInside model={assets.model(name)} />}
    </>
  );
}
