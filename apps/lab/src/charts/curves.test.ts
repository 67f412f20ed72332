import { describe, expect, test } from 'vitest';
import { competitorNames } from '../competitors/competitorNames';
import { madeUpRun } from '../words/testing/madeUpRun';
import { defaultSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { paintOf } from './chartPaint';
import { competitorMark } from './competitorMarks';
import { curvesOf } from './curveData';
import { runNames } from './runNames';
import { sampleRun } from './testing/sampleRuns';
import { linearTicks, logTicks, scaleOf, ticksWithRoom } from './scales';
import { spreadLabels } from './spreadLabels';
import { nearestPoint, walkPoints } from './walkPoints';

describe('curves', () => {
  test('a case without a time breaks the line, and the end says why', () => {
    const run = madeUpRun([1, 2, 3, 4], { stock: [1, null, 3, 'Too many lights.'] });
    const [curve] = curvesOf([run], run.plan.series[0], 'frame');
    expect(curve.pieces.map((piece) => piece.map(({ value }) => value))).toEqual([[1], [3]]);
    expect(curve.end).toBe('Too many lights.');
  });

  test('a line that goes on after a failure has no end', () => {
    const run = madeUpRun([1, 2, 3], { stock: [1, 'Lost its context.', 3] });
    expect(curvesOf([run], run.plan.series[0], 'frame')[0].end).toBeNull();
  });

  test('two runs with other values keep their own', () => {
    const [a, b] = [madeUpRun([1, 10], { deferred: [1, 2] }), madeUpRun([10, 100], { deferred: [3, 4] })];
    const curves = curvesOf([a, b], a.plan.series[0], 'frame');
    expect(curves.map(({ points }) => points.map(({ value }) => value))).toEqual([
      [1, 10],
      [10, 100],
    ]);
    const chart = chartsOf([a, b], defaultSettings).find(({ key }) => key === 'curve-made-up')!;
    expect(chart.table.columns.slice(1)).toEqual(['1 light', '10 lights', '100 lights']);
    expect(chart.table.rows.map((row) => row.slice(1))).toEqual([
      ['1 (1 to 1)', '2 (2 to 2)', '–'],
      ['–', '3 (3 to 3)', '4 (4 to 4)'],
    ]);
  });

  test('charts by another time say so, those of passes and changes have their own', () => {
    const titles = chartsOf([sampleRun()], { ...defaultSettings, metric: 'gpu' }).map(({ key, title }) => [key, title]);
    const named = titles.filter(([, title]) => title.endsWith(', by GPU time')).map(([key]) => key);
    expect(named).toEqual(['map', 'thesis', 'regret']);
  });

  test('the band of percentiles runs along the upper ends and back along the lower ones', () => {
    const spread = (low: number, high: number) => ({ low, median: (low + high) / 2, high, samples: 9 });
    const run = madeUpRun([1, 10, 100], { stock: [spread(1, 2), spread(3, 5), spread(4, 8)] });
    const { svg, points } = chartsOf([run], defaultSettings)
      .find(({ key }) => key === 'curve-made-up')!
      .draw({ width: 800, paint: paintOf('light') });
    const [, path] = /<path d="M([^"]*)Z"[^>]*fill-opacity/.exec(svg)!;
    const band = path.split('L').map((each) => each.split(',').map(Number));
    const places = points.map(({ x }) => Number(x.toFixed(2)));
    expect(band.map(([x]) => x)).toEqual([...places, ...places.toReversed()]);
    points.forEach(({ y }, i) => {
      expect(band[i][1]).toBeLessThan(y);
      expect(band[5 - i][1]).toBeGreaterThan(y);
    });
  });

  test('a series of one case is a ranking, named by the case', () => {
    const run = madeUpRun([100], { forward: [3], deferred: [1], stock: ['Too many lights.'] });
    const [chart] = chartsOf([run], defaultSettings);
    expect(chart.title.replaceAll('\u00a0', ' ')).toBe('Made up, 100 lights, 1280 × 720');
    const { points } = chart.draw({ width: 500, paint: paintOf('light') });
    expect(points.map(({ tip }) => tip.title)).toEqual(['Farol: deferred, 100 lights', 'Farol: forward, 100 lights']);
    expect(points[0].y).toBeLessThan(points[1].y);
  });

  test('with everybody hidden no chart says that nothing was measured', () => {
    const run = sampleRun();
    const charts = chartsOf([run], { ...defaultSettings, hidden: new Set(run.plan.competitors) });
    expect(new Set(charts.flatMap(({ notes }) => notes))).toEqual(
      new Set(['All competitors are hidden: choose one above.']),
    );
  });

  test('the title of a chart of two runs has the sizes of both', () => {
    const [a, b] = [madeUpRun([1, 10], { deferred: [1, 2] }), madeUpRun([1, 10], { deferred: [3, 4] })];
    const [series] = b.plan.series;
    const cases = series.cases.map((labCase) => ({ ...labCase, width: 160, height: 90 }));
    const small = { ...b, plan: { ...b.plan, series: [{ ...series, cases }] } };
    const chart = chartsOf([a, small], defaultSettings).find(({ key }) => key === 'curve-made-up')!;
    expect(chart.title.replaceAll('\u00a0', ' ')).toBe('Made up, 1280 × 720 and 160 × 90');
  });

  test('times of passes on a software rasteriser are told to be the processor’s', () => {
    const run = sampleRun();
    const noteOf = (device: string) =>
      chartsOf([{ ...run, surroundings: { ...run.surroundings, device } }], defaultSettings).find(
        ({ key }) => key === 'passes',
      )!.notes;
    expect(noteOf('NVIDIA H200')).toEqual([]);
    expect(noteOf('SwiftShader Device')).toEqual([
      'A software rasteriser drew this run: its timers count time on the processor, which need not add up to a frame.',
    ]);
  });

  test('hidden competitors are in no line, note or table', () => {
    const run = sampleRun();
    const hidden = new Set(Object.keys(competitorNames).filter((name) => name !== 'deferred'));
    const [chart] = chartsOf([run], { ...defaultSettings, hidden });
    expect(chart.legend).toEqual(['deferred']);
    expect(chart.table.rows).toHaveLength(1);
  });
});

describe('marks of competitors', () => {
  const names = Object.keys(competitorNames);

  test('no two have one symbol', () => {
    const marks = new Set(names.map((name) => `${competitorMark(name).symbol} ${competitorMark(name).hollow}`));
    expect(marks.size).toBe(names.length);
  });

  test.each(['light', 'dark'] as const)(
    'every colour of the %s theme has 3:1 against what lies behind, text 4.5:1',
    (theme) => {
      const paint = paintOf(theme);
      for (const name of names) {
        expect(contrast(paint.competitor(name), paint.background), name).toBeGreaterThanOrEqual(3);
        expect(contrast(paint.competitor(name), paint.over), name).toBeGreaterThanOrEqual(3);
      }
      for (const text of [paint.text, paint.dim]) expect(contrast(text, paint.background)).toBeGreaterThanOrEqual(4.5);
    },
  );
});

test('ticks of a log axis: 1, 2, 5, or fewer where powers are many', () => {
  expect(logTicks(0.9, 11)).toEqual([1, 2, 5, 10]);
  expect(logTicks(0.9, 11_000, 6)).toEqual([1, 10, 100, 1000, 10_000]);
  expect(logTicks(1e-3, 1e9, 5).length).toBeLessThanOrEqual(5);
});

test('who has no figure in a whole series is named with the reason', () => {
  const times = {
    forward: [1, 2],
    stock: ['Too many lights.', 'Too many lights.'],
    babylon: [null, 'Too many lights.'],
  };
  const run = madeUpRun([10, 100], times);
  const notesOf = (metric: 'frame' | 'gpu') =>
    chartsOf([run], { ...defaultSettings, metric }).find(({ key }) => key === 'curve-made-up')!.notes;
  const refused = 'No figure for three’s WebGLRenderer and Babylon.js: Too many lights.';
  expect(notesOf('frame')).toEqual([refused]);
  expect(notesOf('gpu')).toEqual(['No GPU time for forward.', refused]);
});

test('ticks of a linear axis: steps of 1, 2 or 5, within bounds', () => {
  expect(linearTicks(0, 42.5, 9)).toEqual([0, 5, 10, 15, 20, 25, 30, 35, 40]);
  expect(linearTicks(-0.05, 0.22, 5)).toEqual([-0.05, 0, 0.05, 0.1, 0.15, 0.2]);
  expect(linearTicks(1, 1, 3)).toEqual([1]);
  expect(linearTicks(0.3, 2.2, 4)).toEqual([0.5, 1, 1.5, 2]);
});

test('a scale maps the ends of its domain to those of its range, and clamps what lies outside', () => {
  for (const [type, middle] of [
    ['linear', 50],
    ['log', 10],
    ['symlog', Math.sqrt(2 * 101) - 1],
  ] as const) {
    const [low, high] = type === 'linear' ? [0, 100] : [1, 100];
    const scale = scaleOf(type, [low, high], [200, 0]);
    expect([low, middle, high, 1e4].map(scale)).toEqual([200, expect.closeTo(100, 9), 0, 0].map((y) => y));
  }
});

test('ticks without room for their text are left out, the ends never', () => {
  expect(ticksWithRoom([1, 2, 30, 31, 60], (x) => x, 10)).toEqual([1, 30, 60]);
  expect(ticksWithRoom([1, 2], (x) => x, 10)).toEqual([2]);
  expect(ticksWithRoom([], (x) => x, 10)).toEqual([]);
});

test('labels move apart as little as needed, within bounds', () => {
  expect(spreadLabels([50, 10], 10, 0, 100)).toEqual([50, 10]);
  expect(spreadLabels([50, 50], 10, 0, 100)).toEqual([45, 55]);
  expect(spreadLabels([0, 0, 0], 10, 0, 100)).toEqual([0, 10, 20]);
  expect(spreadLabels([1, 2, 3], 10, 0, 15)).toBeNull();
  const places = spreadLabels([5, 7, 6, 90, 99, 98], 8, 0, 100)!.sort((a, b) => a - b);
  for (let i = 1; i < places.length; i++) expect(places[i] - places[i - 1]).toBeGreaterThanOrEqual(8 - 1e-9);
});

test('arrow keys walk a line and change lines; the pointer takes the nearest', () => {
  const tip = { title: '', lines: [] };
  const at = (group: string, order: number, x: number, y: number) => ({ group, order, x, y, tip });
  const [a, b, c, d] = [at('a', 0, 0, 10), at('a', 1, 10, 10), at('b', 0, 0, 20), at('b', 2, 20, 20)];
  const points = [a, b, c, d];
  expect(walkPoints(points, null, 'ArrowRight')).toBe(a);
  expect(walkPoints(points, a, 'ArrowRight')).toBe(b);
  expect(walkPoints(points, b, 'ArrowRight')).toBe(b);
  expect(walkPoints(points, a, 'ArrowDown')).toBe(c);
  expect(walkPoints(points, c, 'ArrowUp')).toBe(a);
  expect(walkPoints(points, c, 'End')).toBe(d);
  expect(walkPoints(points, d, 'Home')).toBe(c);
  expect(walkPoints(points, a, 'Tab')).toBeUndefined();
  expect(nearestPoint(points, 12, 11, 20)).toBe(b);
  expect(nearestPoint(points, 90, 90, 20)).toBeNull();
});

test('runs are called by device and date, those of one day by number', () => {
  expect(runNames([sampleRun(), { ...sampleRun(), name: 'Mine' }, sampleRun()])).toEqual([
    'NVIDIA H200, 2026-11-22, run 1',
    'Mine',
    'NVIDIA H200, 2026-11-22, run 2',
  ]);
});

/** Contrast of two colours by WCAG 2. */
function contrast(a: string, b: string): number {
  const luminance = (colour: string): number => {
    const [r, g, b] = [1, 3, 5]
      .map((i) => Number.parseInt(colour.slice(i, i + 2), 16) / 255)
      .map((part) => (part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}
