import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import { Toggle } from '../../ui/Toggle';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';
import type { Antialiasing, EffectChoice, SwitchedEffect } from '../../viewport/ViewportEffects';
import { Section } from '../inspector/Section';

const antialiasings = (): SelectOption<Antialiasing>[] => [
  { value: 'auto', label: t('Automatic'), help: t('Multisampled where the technique can be, else SMAA.') },
  { value: 'none', label: t('Of the technique'), help: t('Techniques with a G-buffer have none.') },
  { value: 'smaa', label: t('SMAA'), help: t('Smooths the edges of each picture by itself.') },
  { value: 'edges', label: t('Multisampled edges'), help: t('Draws the geometry once more, with 4 samples a pixel.') },
  { value: 'taa', label: t('TAA'), help: t('Gathers frames, each drawn a part of a pixel off.') },
];

const switches = (): { id: SwitchedEffect; label: string; help: string }[] => [
  {
    id: 'ambient-occlusion',
    label: t('Ambient occlusion'),
    help: t('Indirect light reaches less into corners; "Automatic" then takes a technique with a G-buffer.'),
  },
  {
    id: 'order-independent-transparency',
    label: t('Unsorted transparency'),
    help: t('Transparent layers are averaged, not sorted: they may pass through one another.'),
  },
];

/** What takes part in the picture beside the technique. */
export function EffectsSection(): ReactNode {
  const { preferences, viewport } = useEditor();
  const { addedEffects } = viewport;
  useSignal(addedEffects.changed);
  const { antialiasing, on } = usePreferences(({ effects }) => effects);
  const choose = (change: Partial<EffectChoice>): void => {
    preferences.setState({ effects: { antialiasing, on, ...change } });
  };
  return (
    <Section
      id="Frame effects"
      title={t('Effects')}
      help={t('What takes part in the picture beside the technique.')}
      icon="contrast"
    >
      <div className="field">
        <span className="field-label">{t('Anti-aliasing')}</span>
        <SelectBox
          value={antialiasing}
          options={antialiasings()}
          label={t('Anti-aliasing')}
          onChange={(value) => choose({ antialiasing: value })}
        />
      </div>
      {[...switches(), ...addedEffects.list].map(({ id, label, help }) => (
        <div key={id} className="field">
          <span className="field-label">{t(label)}</span>
          <Toggle
            value={on.includes(id)}
            label={t(label)}
            description={t(help)}
            onChange={(isOn) => choose({ on: isOn ? [...on, id] : on.filter((each) => each !== id) })}
          />
        </div>
      ))}
    </Section>
  );
}
