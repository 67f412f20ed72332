import { t } from '@farol/editing';
import type { Effort } from '../../plan/LabPlan';
import { NumberField } from './NumberField';

/** Fields for the duration and repetition of measurements. */
export function EffortFields({ effort, onChange }: { effort: Effort; onChange(effort: Effort): void }) {
  const change = (changes: Partial<Effort>): void => onChange({ ...effort, ...changes });
  const bind = (name: 'rounds' | 'turn' | 'longestFrame') => ({
    value: effort[name],
    onChange: (value: number) => change({ [name]: value }),
  });
  return (
    <fieldset>
      <legend>{t('How thoroughly')}</legend>
      <div class="fields">
        <NumberField label={t('Turns for each')} min={1} max={50} {...bind('rounds')} />
        <NumberField label={t('A turn')} unit="ms" min={20} max={10_000} {...bind('turn')} />
        <NumberField label={t('Leave out frames over')} unit="ms" min={100} max={600_000} {...bind('longestFrame')} />
        {effort.limit !== null && (
          <NumberField
            label={t('The whole run')}
            unit="s"
            value={Math.round(effort.limit / 1000)}
            min={5}
            max={36_000}
            onChange={(seconds) => change({ limit: seconds * 1000 })}
          />
        )}
        <label class="check wide">
          <input
            type="checkbox"
            checked={effort.limit !== null}
            onChange={({ currentTarget }) => change({ limit: currentTarget.checked ? 80_000 : null })}
          />
          {t('Shorten turns so that the run ends in time')}
        </label>
        <label class="check wide">
          <input
            type="checkbox"
            checked={effort.changes}
            onChange={({ currentTarget }) => change({ changes: currentTarget.checked })}
          />
          {t('Measure what a change costs: ten lights more, another technique')}
        </label>
      </div>
    </fieldset>
  );
}
