import type { LabCase, LabSeries } from '../plan/LabPlan';
import type { LabRun } from '../results/LabRun';
import { valueText } from './names';
import { seriesWord } from './seriesLabel';

/** A case of a run and its place in the plan. */
export interface SeriesCase {
  readonly series: LabSeries;
  readonly index: number;
  readonly labCase: LabCase;
  /** Scene and value: `Atrium, 100 lights`; unique in the run unless two series have the same scene and values. */
  readonly label: string;
}

/** All cases of a run, in the order of its plan. */
export function casesOf(run: LabRun): SeriesCase[] {
  return run.plan.series.flatMap((series) =>
    series.cases.map((labCase, index) => ({
      ...{ series, index, labCase },
      label: caseLabel(series, index),
    })),
  );
}

/** Scene and value of a case: `Atrium, 100 lights`. */
export function caseLabel(series: LabSeries, index: number): string {
  return `${seriesWord(series)}, ${valueText(series.axis, series.values[index], series.cases[index])}`;
}
