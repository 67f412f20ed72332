import { t } from '@farol/editing';
import { effectFields } from '@farol/engine';
import { type ReactNode, useMemo } from 'react';
import { setValues } from '../../model/edits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Toggle } from '../../ui/Toggle';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { EffectCosts } from './EffectCosts';
import { FieldList } from '../inspector/FieldList';
import { Section } from '../inspector/Section';
import { TechniqueLimit } from '../inspector/TechniqueLimit';

const shown = ['antialiasing', 'frameBudget', ...Object.keys(effectFields)];

/** Effects of the scene's settings, and effects of plugins. */
export function EffectsSection(): ReactNode {
  const { commands, document, viewport } = useEditor();
  const { addedEffects } = viewport;
  useSignal(addedEffects.changed);
  useSignal(document.opened);
  const { settings } = document.scene;
  const owners = useMemo(() => [settings], [settings]);
  useOwnersRevision(owners);
  const on = settings.pluginEffects.split(',').filter(Boolean);
  const choose = (id: string, isOn: boolean): void => {
    const names = isOn ? [...on, id] : on.filter((each) => each !== id);
    commands.run(setValues(t('Set effects'), owners, { pluginEffects: names.join() }));
  };
  return (
    <Section
      id="Frame effects"
      title={t('Effects')}
      help={t('Parts of the picture besides the technique.')}
      icon="contrast"
    >
      <FieldList owners={owners} names={shown} />
      <TechniqueLimit settings={settings} />
      {addedEffects.list.map(({ id, label, help }) => (
        <div key={id} className="field">
          <span className="field-label">{t(label)}</span>
          <Toggle
            value={on.includes(id)}
            label={t(label)}
            description={t(help)}
            onChange={(isOn) => choose(id, isOn)}
          />
        </div>
      ))}
      <EffectCosts />
    </Section>
  );
}
