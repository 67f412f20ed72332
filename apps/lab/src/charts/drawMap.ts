import { t } from '@farol/editing';
import { formatMs, formatNumber } from '../words/format';
import { competitorLabel, competitorWord } from '../words/names';
import type { ChartPoint, ChartTip, DrawnChart, DrawOptions } from './ChartSpec';
import { fittedText, tag, textTag, textWidth, wrapText } from './svg';
import type { MapCell, WinnerMap } from './winnerMap';

const TOP = 40;

/** Draws the fastest competitor of each case: a cell in its colour, with a strip below for those that tie with it. */
export function drawMap(map: WinnerMap, { width, paint }: DrawOptions): DrawnChart {
  // columns are drawn as rows if there are many and the screen is narrow
  const isTurned = map.columns.length > map.rows.length && (width - 120) / map.columns.length < 64;
  const [columns, rows] = isTurned ? [map.rows, map.columns] : [map.columns, map.rows];
  const [columnTitle, rowTitle] = isTurned ? [map.rowTitle, map.columnTitle] : [map.columnTitle, map.rowTitle];
  const widest = Math.max(...rows.map((row) => textWidth(row)), textWidth(`↓ ${rowTitle}`, 11));
  const marginLeft = Math.round(Math.min(widest + 12, width * 0.4));
  const cellWidth = Math.min(170, (width - marginLeft - 4) / columns.length);
  const inner = cellWidth - 3;
  const cells = map.cells.flatMap(({ winners, ...cell }) => (winners === null ? [] : [{ ...cell, winners }]));
  // names have two lines if any name is too long for one line
  const names = cells.map(({ winners }) =>
    wrapText(competitorWord(winners.best.competitor), inner - 4, 11).slice(0, 2),
  );
  const lines = Math.max(1, ...names.map((name) => name.length));
  const cellHeight = 34 + lines * 13;
  const height = TOP + rows.length * cellHeight + 8;

  const drawn: string[] = [];
  const points: ChartPoint[] = [];
  cells.forEach((cell, i) => {
    const { best, names: winning } = cell.winners;
    const [column, row] = isTurned ? [cell.row, cell.column] : [cell.column, cell.row];
    const left = marginLeft + column * cellWidth;
    const top = TOP + row * cellHeight;
    const centre = left + inner / 2;
    const ties = winning.filter((name) => name !== best.competitor);
    const time = `${ties.length > 0 ? '≈ ' : ''}${formatMs(best.time.median)}`;
    const words = { x: centre, dy: '0.32em', fill: paint.over };
    drawn.push(
      tag('rect', {
        ...{ class: `cell cell-${i}`, x: left, y: top, width: inner, height: cellHeight - 3, rx: 3 },
        fill: paint.competitor(best.competitor),
      }),
      ...ties.map((name, k) =>
        tag('rect', {
          ...{ x: left + (k / ties.length) * inner, y: top + cellHeight - 10, width: inner / ties.length, height: 7 },
          ...{ fill: paint.competitor(name), stroke: paint.background },
        }),
      ),
      ...names[i].map((text, k) => {
        const y = top + 6 + lines * 6.5 + (k - (names[i].length - 1) / 2) * 11;
        return textTag(fittedText(text, inner - 4, 11), { ...words, y, 'font-size': 11 });
      }),
      textTag(textWidth(time) <= inner ? time : formatNumber(best.time.median, 2), {
        ...{ ...words, y: top + 15 + lines * 13, 'font-weight': 'bold' },
      }),
    );
    points.push({
      ...{ x: centre, y: top + cellHeight / 2 - 2, group: `row-${row}`, order: column },
      tip: tipOf(cell.label, cell.winners),
    });
  });
  const label = (words: string, x: number, y: number, fill: string, anchor = 'start', size = 12): string =>
    textTag(words, { x, y, dy: '0.32em', fill, 'text-anchor': anchor, 'font-size': size });
  const titles = [
    label(`${columnTitle} →`, marginLeft, 8, paint.dim),
    label(fittedText(`↓ ${rowTitle}`, marginLeft, 11), 2, TOP - 12, paint.dim, 'start', 11),
    ...columns.map((words, i) =>
      label(fittedText(words, cellWidth - 4), marginLeft + i * cellWidth + inner / 2, TOP - 12, paint.text, 'middle'),
    ),
    ...rows.map((words, i) =>
      label(fittedText(words, marginLeft - 4), 2, TOP + i * cellHeight + cellHeight / 2 - 2, paint.text),
    ),
  ];
  return { height, svg: tag('g', { 'aria-hidden': 'true' }, ...drawn, ...titles), points };
}

function tipOf(title: string, { best, names, entries }: NonNullable<MapCell['winners']>): ChartTip {
  const tied = names.filter((name) => name !== best.competitor).map(competitorWord);
  const next = entries.find(({ competitor }) => !names.includes(competitor));
  return {
    title,
    lines: [
      `${competitorLabel(best.competitor)}: ${formatMs(best.time.median)}`,
      ...(tied.length > 0 ? [t('Ties within the spread: {names}', { names: tied.join(', ') })] : []),
      ...(next
        ? [t('Next: {name}, {time}', { name: competitorLabel(next.competitor), time: formatMs(next.time.median) })]
        : []),
    ],
  };
}
