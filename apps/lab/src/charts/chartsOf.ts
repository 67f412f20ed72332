import type { LabSeries } from '../plan/LabPlan';
import type { LabRun } from '../results/LabRun';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { curveChart } from './curveChart';

/**
 * All charts of one or several runs, in the order of the page. The first run's series come first; later runs are drawn
 * over series of the same name.
 */
export function chartsOf(runs: readonly LabRun[], settings: ChartSettings): ChartSpec[] {
  const shown = runs.map((run) => withoutHidden(run, settings.hidden));
  return seriesOf(shown).map((series) => curveChart(shown, series, settings));
}

/** Series of all runs by name, as the first run that has one plans it. */
export function seriesOf(runs: readonly LabRun[]): LabSeries[] {
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
