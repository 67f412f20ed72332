import { t } from '@farol/editing';
import { Decal, FogVolume, type SceneSettings, techniqueAbilities } from '@farol/engine';
import { type EffectEntry, effects } from '@farol/renderer/effects';
import { type ReactNode, useMemo } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';

type Techniques = Parameters<typeof techniqueAbilities>[0];

/** A line for an effect that the scene's technique leaves out. */
function leftOut({ label, needs = 'depth' }: EffectEntry, techniques: Techniques): string {
  const able = Object.entries(techniques).filter(([name]) => techniqueAbilities(techniques, name)[needs]);
  const words = { effect: t(label).toLowerCase(), names: able.map(([, each]) => t(each.label)).join(', ') };
  return needs === 'depth'
    ? t('This technique has no depth before it lights, so {effect} is left out. {names} have it.', words)
    : t('This technique has no G-buffer, so {effect} is left out. {names} have it.', words);
}

/** Features that the scene uses but its technique does not support, one per line. */
function linesOf(settings: SceneSettings, techniques: Techniques, hasDecals: boolean): string[] {
  const abilities = techniqueAbilities(techniques, settings.technique);
  const lines = Object.values<EffectEntry>(effects)
    .filter(({ setting, needs }) => setting && needs && settings.get(setting) === true && !abilities[needs])
    .map((entry) => leftOut(entry, techniques));
  if (settings.antialiasing === 'none' && !abilities.samples)
    lines.push(t('This technique shades one sample a pixel: edges are jagged. Automatic smooths them by SMAA.'));
  if (hasDecals && !abilities.gbuffer)
    lines.push(t('This technique has no G-buffer: decals are not drawn. Automatic picks one that has it.'));
  return lines;
}

/** Warns of scene features that its technique does not support. */
export function TechniqueLimit({ settings }: { settings: SceneSettings }): ReactNode {
  const { document, viewport } = useEditor();
  useSignal(document.structure);
  useOwnersRevision(useMemo(() => [settings], [settings]));
  const hasDecals = document.scene.componentsOf(Decal).length > 0;
  const lines = linesOf(settings, viewport.farol.techniques, hasDecals);
  if (!settings.volumetricFog && document.scene.componentsOf(FogVolume).length > 0)
    lines.push(t('Volumetric fog is off: fog volumes are not drawn. Switch it on among the effects.'));
  return lines.map((line) => (
    <p key={line} className="technique-limit">
      {line}
    </p>
  ));
}
