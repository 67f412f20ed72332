import { t } from '@farol/editing';
import type { LabRun, Metric } from '../results/LabRun';
import { competitorHelp, competitorLabel, metricWords } from '../words/names';
import { missingMetric } from '../words/compareSpreads';
import type { ChartSettings } from './ChartSpec';
import { competitorSymbol } from './competitorSymbol';
import { pagePaint, runDashes } from './chartPaint';
import { tag } from './svg';

interface Props {
  runs: readonly LabRun[];
  names: readonly string[];
  /** Keys of the competitors of all runs. */
  competitors: readonly string[];
  settings: ChartSettings;
  onChange: (settings: ChartSettings) => void;
}

/** Settings of all charts: metric, axes and competitors; and a legend of the line style of each run. */
export function ChartControls({ runs, names, competitors, settings, onChange }: Props) {
  const { metric, scale, hidden } = settings;
  const toggle = (name: string): void => {
    const next = new Set(hidden);
    if (!next.delete(name)) next.add(name);
    onChange({ ...settings, hidden: next });
  };
  const missing = (Object.keys(metricWords) as Metric[]).map((each) => missingMetric(runs, each)).filter(Boolean);
  return (
    <div class="chart-controls">
      <fieldset>
        <legend>{t('Time')}</legend>
        {(Object.keys(metricWords) as Metric[]).map((each) => {
          const why = missingMetric(runs, each);
          return (
            <button
              key={each}
              type="button"
              aria-pressed={metric === each}
              disabled={why !== null}
              title={why ?? t(metricWords[each].help)}
              onClick={() => onChange({ ...settings, metric: each })}
            >
              {t(metricWords[each].label)}
            </button>
          );
        })}
      </fieldset>
      <fieldset>
        <legend>{t('Axes')}</legend>
        {(['log', 'linear'] as const).map((each) => (
          <button
            key={each}
            type="button"
            aria-pressed={scale === each}
            onClick={() => onChange({ ...settings, scale: each })}
          >
            {each === 'log' ? t('Logarithmic') : t('Linear')}
          </button>
        ))}
      </fieldset>
      {missing.map((why) => (
        <p key={why} class="chart-note">
          {why}
        </p>
      ))}
      <fieldset class="chart-legend">
        <legend>{t('Competitors')}</legend>
        {competitors.map((name) => (
          <button
            key={name}
            type="button"
            title={competitorHelp(name)}
            aria-pressed={!hidden.has(name)}
            onClick={() => toggle(name)}
          >
            <CompetitorSwatch name={name} />
            {competitorLabel(name).replace(/^Farol: /, '')}
          </button>
        ))}
        {hidden.size > 0 && (
          <button type="button" class="chart-all" onClick={() => onChange({ ...settings, hidden: new Set() })}>
            {t('Show all')}
          </button>
        )}
      </fieldset>
      {names.length > 1 && (
        <ul class="chart-runs" aria-label={t('Runs by kind of line')}>
          {names.map((name, i) => (
            <li key={name}>
              <svg width="36" height="8" viewBox="0 0 36 8" aria-hidden="true">
                <path
                  d="M0,4H36"
                  stroke="currentColor"
                  stroke-width="2"
                  stroke-dasharray={runDashes[i % runDashes.length]}
                />
              </svg>
              {name}
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

/** Line and symbol of a competitor in the charts. */
function CompetitorSwatch({ name }: { name: string }) {
  const line = { d: 'M-12,0H12', stroke: pagePaint.competitor(name), 'stroke-width': name === 'auto' ? 2.6 : 1.8 };
  return (
    <svg
      class="chart-swatch"
      width="24"
      height="14"
      viewBox="-12 -7 24 14"
      aria-hidden="true"
      dangerouslySetInnerHTML={{ __html: tag('path', line) + competitorSymbol(name, 0, 0, 4, pagePaint) }}
    />
  );
}
