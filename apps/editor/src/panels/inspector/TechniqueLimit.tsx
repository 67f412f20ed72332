import { t } from '@farol/editing';
import { Decal, type SceneSettings, type TechniqueLimits, techniqueLimits } from '@farol/engine';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { useMemo } from 'react';

/** What the scene asks for and its technique cannot do, a line each. */
function linesOf(
  { occlusion, samples, decals }: TechniqueLimits,
  { ambientOcclusion, antialiasing }: SceneSettings,
  hasDecals: boolean,
): string[] {
  const lines: string[] = [];
  if (ambientOcclusion && occlusion)
    lines.push(
      t(
        'This technique knows no depth before it shades: no ambient occlusion. Automatic, the deferred ones, light pre-pass and Forward+ have it.',
      ),
    );
  if (antialiasing === 'none' && samples)
    lines.push(t('This technique shades one sample a pixel: edges are jagged. Automatic smooths them by SMAA.'));
  if (hasDecals && decals) lines.push(t('This technique has no G-buffer: decals are not seen. Automatic picks one.'));
  return lines;
}

/** What the technique of a scene cannot do of what the scene asks for; nothing where it can do all. */
export function TechniqueLimit({ settings }: { settings: SceneSettings }): ReactNode {
  const { document, viewport } = useEditor();
  useSignal(document.structure);
  useOwnersRevision(useMemo(() => [settings], [settings]));
  const hasDecals = document.scene.componentsOf(Decal).length > 0;
  const limits = techniqueLimits(viewport.farol.techniques, settings.technique);
  return linesOf(limits, settings, hasDecals).map((line) => (
    <p key={line} className="technique-limit">
      {line}
    </p>
  ));
}
