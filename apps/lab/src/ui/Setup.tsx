import { t } from '@farol/editing';
import type { Configuration } from '../plan/Configuration';
import { ownPreset, usesOwnScene } from '../own/ownPreset';
import { presets } from '../plan/presets';
import { Builder } from './builder/Builder';
import { PresetCards } from './PresetCards';
import { planSize, type Planned } from './support/planned';

interface SetupProps {
  configuration: Configuration;
  planned: Planned;
  unavailable: Readonly<Record<string, string | null>>;
  /** Name of the handed-over scene; null for none. */
  ownScene: string | null;
  isBusy: boolean;
  onChange(configuration: Configuration): void;
  onMeasure(): void;
}

/** Presets, the form with all settings of a run (`Builder`), and the button that starts the run. */
export function Setup({ configuration, planned, unavailable, ownScene, isBusy, onChange, onMeasure }: SetupProps) {
  const offered = ownScene === null ? presets : { own: ownPreset(ownScene), ...presets };
  const isOwn = ownScene !== null && usesOwnScene(configuration);
  const isPreset = Object.hasOwn(presets, configuration.preset);
  const label = isPreset ? t(presets[configuration.preset].label) : isOwn ? ownScene : t('your own comparison');
  return (
    <section class="setup" aria-labelledby="setup-title">
      <h2 id="setup-title">{t('What to measure')}</h2>
      <PresetCards presets={offered} chosen={isOwn ? 'own' : configuration.preset} onChoose={onChange} />
      <details class="own">
        <summary>{t('Build your own')}</summary>
        <Builder configuration={configuration} unavailable={unavailable} ownScene={ownScene} onChange={onChange} />
      </details>
      <div class="begin">
        <button type="button" class="framed" disabled={isBusy || planned.plan === null} onClick={onMeasure}>
          {t('Measure: {label}', { label })}
        </button>
        {planned.plan ? (
          <p class="dim">{planSize(planned.plan)}</p>
        ) : (
          <p class="problem" role="alert">
            {planned.problem}
          </p>
        )}
      </div>
    </section>
  );
}
