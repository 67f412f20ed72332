import type { LabRun } from '../results/LabRun';
import { verdictWords } from '../thesis/verdictWords';
import { chartSVG } from './chartSVG';
import { type ChartSettings, defaultSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { sourceOf } from './sourceOf';

/** A chart as a file, with its words for a text around it. */
export interface ChartFile {
  /** Lower-kebab, without an ending. */
  readonly name: string;
  readonly title: string;
  readonly sentences: readonly string[];
  readonly svg: string;
}

/** All charts of runs as files: needs no browser. */
export function chartFiles(
  runs: readonly LabRun[],
  settings: ChartSettings = defaultSettings,
  theme: 'light' | 'dark' = 'light',
): ChartFile[] {
  return chartsOf(runs, settings).map((chart) => ({
    ...{ name: chart.key, title: chart.title, svg: chartSVG(chart, { theme, source: sourceOf(runs) }) },
    sentences: [...chart.sentences, ...chart.verdicts.map(verdictWords)],
  }));
}
