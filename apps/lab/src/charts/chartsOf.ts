import { t } from '@farol/editing';
import type { LabSeries } from '../plan/LabPlan';
import type { LabRun } from '../results/LabRun';
import { thesisChart } from '../thesis/thesisChart';
import { changeChart } from './changeChart';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { curveChart } from './curveChart';
import { mapCharts } from './mapChart';
import { passChart } from './passChart';
import { ratioChart } from './ratioChart';
import { regretChart } from './regretChart';
import { runNames } from './runNames';

/** Kinds of charts that show a single run; `ending`, the end of a chart's key, differs between several runs. */
const kinds: readonly ((
  run: LabRun,
  settings: ChartSettings,
  ending: string,
  runs: readonly LabRun[],
) => ChartSpec[])[] = [
  (run, settings, ending) => mapCharts(run, settings, `map${ending}`),
  (run, settings, ending) => listed(thesisChart(run, settings, `thesis${ending}`)),
  (run, settings, ending) => listed(regretChart(run, settings, `regret${ending}`)),
  (run, settings, ending, runs) => listed(passChart(run, settings, `passes${ending}`, runs)),
  (run, settings, ending) => listed(changeChart(run, settings, `changes${ending}`)),
];

function listed(chart: ChartSpec | null): ChartSpec[] {
  return chart === null ? [] : [chart];
}

/**
 * All charts of one or several runs, in the order of the page: ratios to the first run, curves, the rest. Curves of
 * series with the same name are drawn in one chart for all runs; other charts are drawn for each run.
 */
export function chartsOf(runs: readonly LabRun[], settings: ChartSettings): ChartSpec[] {
  const visible = runs.map((run) => withoutHidden(run, settings.hidden));
  if (settings.hidden.size > 0 && visible.every(({ plan }) => plan.competitors.length === 0)) {
    const notes = [t('All competitors are hidden: choose one above.')];
    return seriesOf(visible).map((series) => ({ ...curveChart(visible, series, settings), notes }));
  }
  const names = runNames(runs);
  const single = kinds.flatMap((make) =>
    visible.flatMap((run, i) => {
      const charts = make(run, settings, i === 0 ? '' : `-run-${i + 1}`, visible);
      return runs.length === 1 ? charts : charts.map((chart) => ({ ...chart, title: `${chart.title}: ${names[i]}` }));
    }),
  );
  const ratios = visible.slice(1).flatMap((run, i) => {
    const key = i === 0 ? 'ratio' : `ratio-${i + 2}`;
    return listed(ratioChart([visible[0], names[0]], [run, names[i + 1]], settings, key));
  });
  return [...ratios, ...seriesOf(visible).map((series) => curveChart(visible, series, settings)), ...single];
}

/** Series of all runs, one for each name, as planned by the first run that has it. */
function seriesOf(runs: readonly LabRun[]): LabSeries[] {
  const byName = new Map<string, LabSeries>();
  for (const { plan } of runs) {
    for (const series of plan.series) if (!byName.has(series.name)) byName.set(series.name, series);
  }
  return [...byName.values()];
}

function withoutHidden(run: LabRun, hidden: ReadonlySet<string>): LabRun {
  if (hidden.size === 0) return run;
  return {
    ...run,
    plan: { ...run.plan, competitors: run.plan.competitors.filter((name) => !hidden.has(name)) },
    rows: run.rows.filter(({ competitor }) => !hidden.has(competitor)),
  };
}
