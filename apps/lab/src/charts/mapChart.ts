import type { LabRun } from '../results/LabRun';
import { formatMs } from '../words/format';
import { mapWords } from '../words/mapWords';
import { competitorLabel, competitorWord, metricWords } from '../words/names';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { drawMap } from './drawMap';
import { winnerMaps } from './winnerMap';

/** Maps of who wins where: one for each pair of properties that the run varies. */
export function mapCharts(run: LabRun, { metric }: ChartSettings, key = 'map'): ChartSpec[] {
  return winnerMaps(run, metric).map((map, place, { length }) => {
    const winners = map.cells.flatMap(({ winners }) => winners ?? []);
    const shown = new Set(winners.flatMap(({ names }) => names));
    const cellOf = (row: number, column: number): string => {
      const found = map.cells.find((cell) => cell.row === row && cell.column === column)?.winners;
      if (!found) return '–';
      const [first, ...others] = [found.best.competitor, ...found.names.filter((n) => n !== found.best.competitor)];
      const tie = others.length > 0 ? `; ties with ${others.map(competitorWord).join(', ')}` : '';
      return `${competitorLabel(first)}, ${formatMs(found.best.time.median)}${tie}`;
    };
    return {
      key: place === 0 ? key : `${key}-${place + 1}`,
      title: length === 1 ? 'Who wins where' : `Who wins where: ${map.columnTitle.toLowerCase()}`,
      description: `The fastest competitor by ${metricWords[metric].noun} in each case: ${map.rowTitle.toLowerCase()} by ${map.columnTitle.toLowerCase()}, a cell a case, coloured by the winner.`,
      sentences: mapWords(winners),
      verdicts: [],
      notes: winners.some(({ names }) => names.length > 1)
        ? ['≈ marks a tie: the strip below a cell has the colours of those that tie with the shortest median.']
        : [],
      table: {
        columns: [map.rowTitle, ...map.columns],
        rows: map.rows.map((words, row) => [words, ...map.columns.map((_, column) => cellOf(row, column))]),
      },
      legend: [...shown].sort((a, b) => competitorOrder(a) - competitorOrder(b)),
      ...{ keys: [], runs: [], choice: null, wide: false },
      draw: (options) => drawMap(map, options),
    };
  });
}
