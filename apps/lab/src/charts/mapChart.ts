import { t } from '@farol/editing';
import type { LabRun } from '../results/LabRun';
import { formatMs } from '../words/format';
import { byMetric, competitorLabel, competitorWord, metricWords } from '../words/names';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { drawMap } from './drawMap';
import { winnerMaps } from './winnerMap';

/** Maps of the fastest competitor: one for each pair of properties that the run varies. */
export function mapCharts(run: LabRun, { metric }: ChartSettings, key = 'map'): ChartSpec[] {
  return winnerMaps(run, metric).map((map, place, { length }) => {
    const winners = map.cells.flatMap(({ winners }) => winners ?? []);
    const winning = new Set(winners.flatMap(({ names }) => names));
    const cellOf = (row: number, column: number): string => {
      const found = map.cells.find((cell) => cell.row === row && cell.column === column)?.winners;
      if (!found) return '–';
      const [first, ...others] = [found.best.competitor, ...found.names.filter((n) => n !== found.best.competitor)];
      const tie =
        others.length > 0 ? `; ${t('ties with {names}', { names: others.map(competitorWord).join(', ') })}` : '';
      return `${competitorLabel(first)}, ${formatMs(found.best.time.median)}${tie}`;
    };
    return {
      key: place === 0 ? key : `${key}-${place + 1}`,
      title: `${t('Who wins where')}${length === 1 ? '' : `: ${map.columnTitle.toLowerCase()}`}${byMetric(metric)}`,
      description: t(
        'The fastest competitor by {time} in each case: {rows} by {columns}, a cell a case, coloured by the winner.',
        {
          time: t(metricWords[metric].noun),
          rows: map.rowTitle.toLowerCase(),
          columns: map.columnTitle.toLowerCase(),
        },
      ),
      notes: winners.some(({ names }) => names.length > 1)
        ? [t('≈ marks a tie: the strip below a cell has the colours of those that tie with the shortest median.')]
        : [],
      table: {
        columns: [map.rowTitle, ...map.columns],
        rows: map.rows.map((words, row) => [words, ...map.columns.map((_, column) => cellOf(row, column))]),
      },
      legend: [...winning].sort((a, b) => competitorOrder(a) - competitorOrder(b)),
      draw: (options) => drawMap(map, options),
    };
  });
}
