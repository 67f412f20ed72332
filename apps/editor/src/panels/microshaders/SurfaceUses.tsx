import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { usagesOf } from '../../model/assetUsages';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Chunks } from './ChunkUses';

/** Uniforms of a surface, microshaders that it includes, and materials and objects that use it. */
export function SurfaceUses({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.materials);
  useSignal(document.assetsChanged);
  const surface = document.assets.surface(name)?.surface;
  const included = [...(surface?.source.matchAll(/^[ \t]*#include[ \t]+"([^"\n]*)"/gm) ?? [])].map((match) => match[1]);
  const wearers = usagesOf(document.scene, name);
  return (
    <aside className="chunk-uses" aria-label={t('Uses of {name}', { name })}>
      <h3>{t('Uniforms')}</h3>
      <p>{surface?.uniforms.map((uniform) => `${uniform.name} (${uniform.type})`).join(', ') || t('None.')}</p>
      <Chunks title={t('Needs')} names={included} />
      <h3>{t('Used by')}</h3>
      {wearers.length === 0 && <p>{t('Nothing. Drag it from Assets onto an object.')}</p>}
      <ul>
        {wearers.map(({ place, object }) => (
          <li key={object ?? place}>
            <button
              type="button"
              onClick={() =>
                object === undefined ? document.assetSelection.set([place]) : document.selection.set([object])
              }
            >
              {place}
            </button>
          </li>
        ))}
      </ul>
      <p>
        {t(
          'It runs on the graphics card alone, and needs no permission. A loop without an end can stall the whole page.',
        )}
      </p>
    </aside>
  );
}
