import { SetFields, t } from '@farol/editing';
import { type Component, SunAndMoon } from '@farol/engine';
import { lightPresets, type PhotometricLight, valuesOfPreset } from '@farol/engine/photometry';
import type { ReactNode } from 'react';
import { ownersName } from '../../model/ownersName';
import { useEditor } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';

/** Menu of measured lamps and skies whose values the lights can take. @param props.components - Lights, memoised */
export function LightBar({ components }: { components: readonly Component[] }): ReactNode {
  const { commands } = useEditor();
  const become = (preset: keyof typeof lightPresets, name: string): void => {
    const edits = components.flatMap((owner) =>
      Object.entries(valuesOfPreset(lightPresets[preset], owner as unknown as PhotometricLight)).map(
        ([field, value]) => ({ owner, name: field, value }),
      ),
    );
    commands.run(
      new SetFields(t('Made {name} a light like {preset}', { name: ownersName(components), preset: name }), edits),
    );
  };
  return (
    <div className="material-bar">
      <MenuButton
        label={t('Presets')}
        icon="point"
        entries={() =>
          Object.entries(lightPresets).map(([preset, { label, type }]) => ({
            label: t(label),
            icon: type,
            run: () => become(preset, t(label)),
          }))
        }
      />
      {components.some(({ gameObject }) => gameObject.getComponent(SunAndMoon)?.isActive) && (
        <p className="model-problem">{t('Sun and moon give this light its colour, intensity and direction.')}</p>
      )}
    </div>
  );
}
