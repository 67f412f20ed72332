import { t } from '@farol/editing';
import { useId } from 'preact/hooks';
import type { Configuration } from '../plan/Configuration';
import { estimate, planOf } from '../plan/planOf';
import type { Preset } from '../plan/presets';
import { roughDuration } from './support/formatDuration';

interface PresetCardsProps {
  presets: Readonly<Record<string, Preset>>;
  /** Key of the chosen preset; any other text for none. */
  chosen: string;
  onChoose(configuration: Configuration): void;
}

/** Cards of the presets; a click copies the settings of a preset to the form below the cards. */
export function PresetCards({ presets, chosen, onChoose }: PresetCardsProps) {
  return (
    <ul class="presets">
      {Object.entries(presets).map(([name, preset]) => (
        <li key={name}>
          <PresetCard preset={preset} isChosen={name === chosen} onChoose={() => onChoose(preset.configuration)} />
        </li>
      ))}
    </ul>
  );
}

interface PresetCardProps {
  preset: Preset;
  isChosen: boolean;
  onChoose(): void;
}

function PresetCard({ preset, isChosen, onChoose }: PresetCardProps) {
  const id = useId();
  const time = roughDuration(estimate(planOf(preset.configuration)));
  return (
    <button
      type="button"
      class="preset"
      aria-pressed={isChosen}
      aria-labelledby={`${id}-label`}
      aria-describedby={`${id}-help ${id}-time`}
      onClick={onChoose}
    >
      <span class="preset-head">
        <strong id={`${id}-label`}>{t(preset.label)}</strong>
        <span id={`${id}-time`} class="preset-time">
          <span class="visually-hidden">{t('takes about')} </span>
          {time}
        </span>
      </span>
      <span id={`${id}-help`} class="preset-help">
        {t(preset.help)}
      </span>
    </button>
  );
}
