import { t } from '@farol/editing';
import { Decal, type SceneSettings, techniqueLimits } from '@farol/engine';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { useMemo } from 'react';

/** Features that the scene uses but its technique does not support, a line each. */
function limitsOf({ technique, ambientOcclusion, antialiasing }: SceneSettings, hasDecals: boolean): string[] {
  const { occlusion, samples, decals } = techniqueLimits(technique);
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

/** Warns of scene features that its technique does not support. */
export function TechniqueLimit({ settings }: { settings: SceneSettings }): ReactNode {
  const { document } = useEditor();
  useSignal(document.structure);
  useOwnersRevision(useMemo(() => [settings], [settings]));
  const hasDecals = document.scene.componentsOf(Decal).length > 0;
  return limitsOf(settings, hasDecals).map((line) => (
    <p key={line} className="technique-limit">
      {line}
    </p>
  ));
}
