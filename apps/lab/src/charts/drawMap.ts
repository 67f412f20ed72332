import { plot, rect, text } from '@observablehq/plot';
import { formatMs, formatNumber } from '../words/format';
import { competitorLabel, competitorWord } from '../words/names';
import type { ChartPoint, ChartTip, DrawnChart, DrawOptions } from './ChartSpec';
import { plotStyle } from './plotMarks';
import { fittedText, svgElement, textWidth } from './svgElement';
import type { MapCell, WinnerMap } from './winnerMap';
import { wrapText } from './wrapText';

const TOP = 40;

/** Draws who is fastest in each case: a cell a case, coloured by the winner; a strip below a cell names who ties with it. */
export function drawMap(map: WinnerMap, { width, paint, document = globalThis.document }: DrawOptions): DrawnChart {
  // many columns on a narrow screen: columns become rows
  const isTurned = map.columns.length > map.rows.length && (width - 120) / map.columns.length < 64;
  const [columns, rows] = isTurned ? [map.rows, map.columns] : [map.columns, map.rows];
  const [columnTitle, rowTitle] = isTurned ? [map.rowTitle, map.columnTitle] : [map.columnTitle, map.rowTitle];
  const marginLeft = Math.round(
    Math.min(Math.max(...rows.map((row) => textWidth(row)), textWidth(`↓ ${rowTitle}`, 11)) + 12, width * 0.4),
  );
  const cellWidth = Math.min(170, (width - marginLeft - 4) / columns.length);
  const inner = cellWidth - 3;
  const cells = map.cells.filter(({ winners }) => winners !== null);
  // names in two lines where one is too narrow for any of them
  const names = cells.map((cell) => wrapText(competitorWord(cell.winners!.best.competitor), inner - 4, 11).slice(0, 2));
  const lines = Math.max(1, ...names.map((name) => name.length));
  const cellHeight = 34 + lines * 13;
  const height = TOP + rows.length * cellHeight + 8;
  const column = (cell: MapCell): number => (isTurned ? cell.row : cell.column);
  const row = (cell: MapCell): number => (isTurned ? cell.column : cell.row);
  const left = (cell: MapCell): number => marginLeft + column(cell) * cellWidth;
  const top = (cell: MapCell): number => TOP + row(cell) * cellHeight;
  const best = (cell: MapCell): string => cell.winners!.best.competitor;
  const ties = cells.flatMap((cell) => {
    const others = cell.winners!.names.filter((name) => name !== best(cell));
    return others.map((name, i) => ({ cell, name, from: i / others.length, to: (i + 1) / others.length }));
  });
  const svg = plot({
    ...{ width, height, document, margin: 0, style: { ...plotStyle, color: paint.text }, color: { type: 'identity' } },
    x: { type: 'linear', domain: [0, width], range: [0, width], axis: null },
    y: { type: 'linear', domain: [0, height], range: [0, height], axis: null },
    marks: [
      ...cells.map((cell, i) =>
        rect([cell], {
          ...{
            x1: left,
            x2: (each: MapCell) => left(each) + inner,
            y1: top,
            y2: (each: MapCell) => top(each) + cellHeight - 3,
          },
          ...{ fill: paint.competitor(best(cell)), rx: 3, ariaHidden: 'true', className: `cell cell-${i}` },
        }),
      ),
      rect(ties, {
        x1: ({ cell, from }: (typeof ties)[0]) => left(cell) + from * inner,
        x2: ({ cell, to }: (typeof ties)[0]) => left(cell) + to * inner,
        y1: ({ cell }: (typeof ties)[0]) => top(cell) + cellHeight - 10,
        y2: ({ cell }: (typeof ties)[0]) => top(cell) + cellHeight - 3,
        ...{
          fill: ({ name }: (typeof ties)[0]) => paint.competitor(name),
          stroke: paint.background,
          ariaHidden: 'true',
        },
      }),
      text(cells, {
        ...{
          x: (cell: MapCell) => left(cell) + inner / 2,
          y: (cell: MapCell) => top(cell) + 6 + lines * 6.5,
          fill: paint.over,
        },
        ...{
          text: (_: MapCell, i: number) => names[i].map((line) => fittedText(line, inner - 4, 11)).join('\n'),
          fontSize: 11,
          ariaHidden: 'true',
        },
      }),
      text(cells, {
        ...{
          x: (cell: MapCell) => left(cell) + inner / 2,
          y: (cell: MapCell) => top(cell) + 15 + lines * 13,
          fill: paint.over,
        },
        text: (cell: MapCell) => msText(cell, inner),
        ...{ fontSize: 12, fontWeight: 'bold', ariaHidden: 'true' },
      }),
    ],
  } as Parameters<typeof plot>[0]) as SVGSVGElement;
  const label = (words: string, x: number, y: number, anchor: string, colour: string, size = 12): void =>
    svg.append(
      svgElement(
        document,
        'text',
        { x, y, 'text-anchor': anchor, fill: colour, 'font-size': size, dy: '0.32em' },
        words,
      ),
    );
  label(`${columnTitle} →`, marginLeft, 8, 'start', paint.dim);
  label(fittedText(`↓ ${rowTitle}`, marginLeft, 11), 2, TOP - 12, 'start', paint.dim, 11);
  columns.forEach((words, i) =>
    label(fittedText(words, cellWidth - 4), marginLeft + i * cellWidth + inner / 2, TOP - 12, 'middle', paint.text),
  );
  rows.forEach((words, i) =>
    label(fittedText(words, marginLeft - 4), 2, TOP + i * cellHeight + cellHeight / 2 - 2, 'start', paint.text),
  );
  const points = cells.map((cell): ChartPoint => {
    const at = { x: left(cell) + inner / 2, y: top(cell) + cellHeight / 2 - 2 };
    return { ...at, group: `row-${row(cell)}`, order: column(cell), tip: tipOf(cell) };
  });
  return { svg, points };
}

function msText({ winners }: MapCell, room: number): string {
  const { median } = winners!.best.time;
  const whole = `${winners!.names.length > 1 ? '≈ ' : ''}${formatMs(median)}`;
  return textWidth(whole, 12) <= room ? whole : formatNumber(median, 2);
}

function tipOf({ of, winners }: MapCell): ChartTip {
  const { best, names, entries } = winners!;
  const tied = names.filter((name) => name !== best.competitor).map(competitorWord);
  const next = entries.find(({ competitor }) => !names.includes(competitor));
  return {
    title: of.label,
    lines: [
      `${competitorLabel(best.competitor)}: ${formatMs(best.time.median)}`,
      ...(tied.length > 0 ? [`Ties within the spread: ${tied.join(', ')}`] : []),
      ...(next ? [`Next: ${competitorLabel(next.competitor)}, ${formatMs(next.time.median)}`] : []),
    ],
  };
}
