import { t } from '@farol/editing';
import { type Axis, isNamed, type LabSeries } from '../plan/LabPlan';
import { axisLabel } from '../plan/sceneWords';
import type { LabRun, Metric } from '../results/LabRun';
import { casesOf, type SeriesCase } from '../words/seriesCases';
import { seriesWord } from '../words/seriesLabel';
import { namedValue, valueText } from '../words/names';
import { type Winners, winnersOf } from '../words/winners';
import { formatNumber } from '../words/format';

/** A cell of a map; its winners are null if no competitor has a time. */
export interface MapCell {
  readonly row: number;
  readonly column: number;
  /** Scene and value along the axis, as text. */
  readonly label: string;
  readonly winners: Winners | null;
}

/** A table of cases by two of their properties; each cell shows the fastest competitor of its case. */
export interface WinnerMap {
  readonly rows: readonly string[];
  readonly columns: readonly string[];
  readonly rowTitle: string;
  readonly columnTitle: string;
  readonly cells: readonly MapCell[];
}

/**
 * Maps of a run: of lights by pixels for each scene with several values of both; of series by value, one map per axis,
 * for all other cases. Maps with fewer than two cases that several competitors drew are left out.
 */
export function winnerMaps(run: LabRun, metric: Metric): WinnerMap[] {
  const cases = casesOf(run);
  const maps: WinnerMap[] = [];
  const placed = new Set<SeriesCase>();
  for (const group of groupBy(cases, sceneKey).values()) {
    const pixels = [...new Set(group.map(({ labCase }) => labCase.width * labCase.height))].sort((a, b) => a - b);
    const lights = [...new Set(group.map(({ labCase }) => labCase.lights ?? 0))].sort((a, b) => a - b);
    if (pixels.length < 2 || lights.length < 2) continue;
    group.forEach((each) => placed.add(each));
    const size = (count: number): string => {
      const { labCase } = group.find(({ labCase: { width, height } }) => width * height === count)!;
      return `${labCase.width} × ${labCase.height}`;
    };
    maps.push({
      rows: pixels.map(size),
      columns: lights.map((count) => valueText('lights', count)),
      rowTitle: t('{scene}: pixels', { scene: group[0].label.split(',')[0] }),
      columnTitle: axisLabel({ axis: 'lights', cases: group.map(({ labCase }) => labCase) }),
      cells: group.map(({ labCase, series, index, label }) => ({
        row: pixels.indexOf(labCase.width * labCase.height),
        column: lights.indexOf(labCase.lights ?? 0),
        ...{ label, winners: winnersOf(run, series, index, metric) },
      })),
    });
  }
  const rest = cases.filter((each) => !placed.has(each));
  for (const group of groupBy(rest, ({ series }) => series.axis).values()) maps.push(bySeries(run, group, metric));
  // a case that only one competitor drew has no winner
  const isContest = ({ winners }: MapCell): boolean => winners !== null && winners.entries.length > 1;
  return maps.filter(({ cells }) => cells.filter(isContest).length > 1);
}

function bySeries(run: LabRun, group: readonly SeriesCase[], metric: Metric): WinnerMap {
  const { axis } = group[0].series;
  const values = [...new Set(group.map(({ series, index }) => series.values[index]))].sort((a, b) => a - b);
  const list: LabSeries[] = [...new Set(group.map(({ series }) => series))];
  return {
    rows: list.map(seriesWord),
    columns: values.map((value) => columnText(axis, value)),
    rowTitle: t('Series'),
    columnTitle: axisLabel({ axis, cases: list.flatMap(({ cases }) => cases) }),
    cells: group.map(({ series, index, label }) => ({
      row: list.indexOf(series),
      column: values.indexOf(series.values[index]),
      ...{ label, winners: winnersOf(run, series, index, metric) },
    })),
  };
}

function columnText(axis: Axis, value: number): string {
  if (isNamed(axis)) return namedValue(axis, value);
  return axis === 'pixels' ? `${formatNumber(value / 1e6, 2)} M` : formatNumber(value, 6);
}

/** Key of a case: cases with the same key are in one map of lights by pixels. */
function sceneKey({ labCase }: SeriesCase): string {
  const { scene, shadows, lightKind, lightRange, shading, overdraw } = labCase;
  return JSON.stringify([scene.name, scene.parameters, shadows, lightKind, lightRange, shading, overdraw]);
}

function groupBy<T>(items: readonly T[], key: (item: T) => string): Map<string, T[]> {
  const groups = new Map<string, T[]>();
  for (const item of items) groups.set(key(item), [...(groups.get(key(item)) ?? []), item]);
  return groups;
}
