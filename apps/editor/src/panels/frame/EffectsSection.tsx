import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import { Toggle } from '../../ui/Toggle';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';
import type { Antialiasing, EffectChoice, SwitchedEffect } from '../../viewport/ViewportEffects';
import { Section } from '../inspector/Section';

const antialiasings: readonly SelectOption<Antialiasing>[] = [
  { value: 'auto', label: 'Automatic', help: 'Multisampled where the technique can be, else SMAA.' },
  { value: 'none', label: 'Of the technique', help: 'Techniques with a G-buffer have none.' },
  { value: 'smaa', label: 'SMAA', help: 'Smooths the edges of each picture by itself.' },
  { value: 'edges', label: 'Multisampled edges', help: 'Draws the geometry once more, with 4 samples a pixel.' },
  { value: 'taa', label: 'TAA', help: 'Gathers frames, each drawn a part of a pixel off.' },
];

const switches: readonly { id: SwitchedEffect; label: string; help: string }[] = [
  {
    id: 'ambient-occlusion',
    label: 'Ambient occlusion',
    help: 'Indirect light reaches less into corners; "Automatic" then takes a technique with a G-buffer.',
  },
  {
    id: 'order-independent-transparency',
    label: 'Unsorted transparency',
    help: 'Transparent layers are averaged, not sorted: they may pass through one another.',
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
      title="Effects"
      help="What takes part in the picture beside the technique."
      icon="contrast"
    >
      <div className="field">
        <span className="field-label">Anti-aliasing</span>
        <SelectBox
          value={antialiasing}
          options={antialiasings}
          label="Anti-aliasing"
          onChange={(value) => choose({ antialiasing: value })}
        />
      </div>
      {[...switches, ...addedEffects.list].map(({ id, label, help }) => (
        <div key={id} className="field">
          <span className="field-label">{label}</span>
          <Toggle
            value={on.includes(id)}
            label={label}
            description={help}
            onChange={(isOn) => choose({ on: isOn ? [...on, id] : on.filter((each) => each !== id) })}
          />
        </div>
      ))}
    </Section>
  );
}
