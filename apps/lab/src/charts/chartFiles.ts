import type { LabRun } from '../results/LabRun';
import { verdictWords } from '../thesis/verdictWords';
import { chartSVG } from './chartSVG';
import { type ChartSettings, type ChartSpec, defaultSettings } from './ChartSpec';
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
  return chartsOf(runs, settings)
    .flatMap((chart) => byBaseline(chart, runs, settings))
    .map(([name, chart]) => ({
      ...{ name, title: chart.title, svg: chartSVG(chart, { theme, source: sourceOf(runs) }) },
      sentences: [...chart.sentences, ...chart.verdicts.map(verdictWords)],
    }));
}

/** The comparison with the thesis once for each renderer that may stand for its forward; other charts as they are. */
function byBaseline(
  chart: ChartSpec,
  runs: readonly LabRun[],
  settings: ChartSettings,
): (readonly [name: string, chart: ChartSpec])[] {
  const { key, title, choice, verdicts } = chart;
  if (!choice || verdicts.length === 0) return [[key, chart]];
  return choice.options.map((option, i) => {
    const cases = { ...settings.cases, [key]: i };
    const chosen = chartsOf(runs, { ...settings, cases }).find((each) => each.key === key)!;
    const name = option.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-');
    return [`${key}-${name}`, { ...chosen, title: `${title}, forward by ${option}` }] as const;
  });
}
