import { t } from '@farol/editing';
import { useMemo, useState } from 'preact/hooks';
import { axisLabel } from '../plan/sceneWords';
import { compareRuns, type ComparedRow } from './compareRuns';
import { compareSpreads, SAME } from '../words/compareSpreads';
import { formatDate, formatNumber } from '../words/format';
import { caseText, competitorLabel } from '../words/names';
import { seriesLabel } from '../words/seriesLabel';
import { Select } from '../ui/Select';
import type { LabRun, Metric } from './LabRun';
import './results.css';

const metrics: Readonly<Record<Metric, string>> = {
  gpu: 'GPU time',
  frame: 'Time of a frame',
  cpu: 'CPU time in the call that draws',
};

/** Two runs side by side: their differences, each competitor's mean ratio of times, and every case that both have. */
export function Comparison({ a, b }: { a: LabRun; b: LabRun }) {
  const [chosen, setChosen] = useState<Metric | null>(null);
  const compared = useMemo(() => compareRuns(a, b, chosen ?? undefined), [a, b, chosen]);
  const { metric, rows, competitors, differences } = compared;
  const series = [...new Set(rows.map((row) => row.series))];
  return (
    <section class="comparison" aria-labelledby="comparison-title">
      <h2 id="comparison-title">{t('Two runs side by side')}</h2>
      <dl class="comparison-runs">
        <dt>{t('First')}</dt>
        <dd>{runWords(a)}</dd>
        <dt>{t('Second')}</dt>
        <dd>{runWords(b)}</dd>
      </dl>
      {differences.length > 0 && (
        <ul class="comparison-differences" aria-label={t('Differences of the runs')}>
          {differences.map((each) => (
            <li key={each}>{each}</li>
          ))}
        </ul>
      )}
      {rows.length > 0 && (
        <>
          <Select
            class="inline-field"
            label={t('Compare')}
            value={metric}
            options={Object.entries(metrics).map(([key, label]) => [key, t(label)])}
            onChange={(next) => setChosen(next as Metric)}
          />
          <div class="table-scroll" tabIndex={0} role="region" aria-label={t('Means by competitor')}>
            <table class="rows">
              <caption>{t('Geometric mean of the ratios over the cases that both runs have')}</caption>
              <thead>
                <tr>
                  <th scope="col">{t('Competitor')}</th>
                  <th scope="col">{t('Cases')}</th>
                  <th scope="col">{t('First ÷ second')}</th>
                  <th scope="col" class="text">
                    {t('In words')}
                  </th>
                </tr>
              </thead>
              <tbody>
                {competitors.map(({ competitor, cases, ratio }) => (
                  <tr key={competitor}>
                    <th scope="row">{competitorLabel(competitor)}</th>
                    <td>{cases}</td>
                    <td>{digits(ratio)}</td>
                    <td class={`text ${kindOf(ratio)}`}>{ratioWords(ratio)}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
          {series.map((each) => (
            <SeriesTable key={each.name} rows={rows.filter((row) => row.series === each)} />
          ))}
        </>
      )}
    </section>
  );
}

function SeriesTable({ rows }: { rows: readonly ComparedRow[] }) {
  const label = seriesLabel(rows[0].series);
  return (
    <div class="table-scroll" tabIndex={0} role="region" aria-label={label}>
      <table class="rows">
        <caption>{label}</caption>
        <thead>
          <tr>
            <th scope="col">{axisLabel(rows[0].series)}</th>
            <th scope="col" class="text">
              {t('Competitor')}
            </th>
            <th scope="col">{t('First (ms)')}</th>
            <th scope="col">{t('Second (ms)')}</th>
            <th scope="col">{t('First ÷ second')}</th>
            <th scope="col" class="text">
              {t('In words')}
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({ competitor, index, value, a, b, ratio, times }) => (
            <tr key={`${value} ${competitor}`}>
              <th scope="row">{caseText(rows[0].series, index)}</th>
              <td class="text">{competitorLabel(competitor)}</td>
              <td>{digits(a)}</td>
              <td>{digits(b)}</td>
              <td>{digits(ratio)}</td>
              <td class={`text ${isTie(times) ? 'same' : kindOf(ratio)}`}>
                {isTie(times) ? t('a tie: within the spread') : ratioWords(ratio)}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Whether two times count as a tie, see `compareSpreads`. */
const isTie = (times: ComparedRow['times']): boolean => times !== null && compareSpreads(...times) === 0;

/** How much faster or slower the second run is than the first, in words. @param ratio - first run's time / second's */
function ratioWords(ratio: number | null): string {
  if (ratio === null) return t('no figure in one of them');
  if (kindOf(ratio) === 'same') return t('the same within 3%');
  return ratio > 1
    ? t('the second is {factor} × faster', { factor: digits(ratio) })
    : t('the second is {factor} × slower', { factor: digits(1 / ratio) });
}

function kindOf(ratio: number | null): 'faster' | 'slower' | 'same' {
  if (ratio === null || Math.abs(Math.log(ratio)) < Math.log(1 + SAME)) return 'same';
  return ratio > 1 ? 'faster' : 'slower';
}

/** A number, or a dash for none. */
const digits = (value: number | null): string => formatNumber(value ?? Number.NaN);

function runWords({ name, plan, surroundings }: LabRun): string {
  const { device, browser, system, date } = surroundings;
  return `${name || t(plan.label)}: ${device}; ${browser}, ${system}; ${formatDate(date)}`;
}
