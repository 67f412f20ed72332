import { describe, expect, test } from 'vitest';
import { madeUpRun } from '../words/testing/madeUpRun';
import { chartFiles } from './chartFiles';
import { chartSVG } from './chartSVG';
import type { ChartSettings } from './ChartSpec';
import { defaultSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { paintOf } from './chartPaint';
import { passChart } from './passChart';
import { sampleRun } from './testing/sampleRuns';
import { sourceOf } from './runNames';
import type { LabRun } from '../results/LabRun';

const filesOf = (runs: LabRun[], settings: ChartSettings = defaultSettings) =>
  chartsOf(runs, settings).map((chart) => ({ ...chart, svg: chartSVG(chart, { source: sourceOf(runs) }) }));

describe.each(['quick', 'thesis', 'resolution'])('charts of a %s run', (preset) => {
  const run = sampleRun({ preset });

  test('every chart is drawn at every width, its points inside and told in words', () => {
    for (const chart of chartsOf([run], defaultSettings)) {
      for (const width of [240, 800]) {
        const { svg, height, points } = chart.draw({ width, paint: paintOf('dark') });
        expect(points.length, chart.key).toBeGreaterThan(0);
        for (const { x, y, tip } of points) {
          expect(x >= 0 && x <= width && y >= 0 && y <= height, `${chart.key} at ${width}: ${x}, ${y}`).toBe(true);
          expect(tip.title).not.toBe('');
        }
        expect(svg).not.toMatch(/NaN|undefined|Infinity/);
      }
    }
  });

  test('every chart has a description and a table of one width', () => {
    const charts = chartsOf([run], defaultSettings);
    expect(new Set(charts.map(({ key }) => key)).size).toBe(charts.length);
    for (const { key, title, description, notes, table } of charts) {
      expect(title && description, key).toBeTruthy();
      for (const row of table.rows) expect(row.length, key).toBe(table.columns.length);
      expect(JSON.stringify([notes, table, description]), key).not.toMatch(/NaN|undefined|Infinity/);
    }
  });

  test('files stand by themselves: no custom property, the notes inside', () => {
    for (const { key, svg, title, notes = [] } of filesOf([run])) {
      expect(svg.startsWith('<svg xmlns="http://www.w3.org/2000/svg"'), key).toBe(true);
      expect(svg, key).not.toMatch(/var\(|light-dark|NaN|undefined|<style/);
      expect(svg, key).toContain(`<title id="title">${title}</title>`);
      for (const note of notes) expect(svg, key).toContain(note.split(' ')[0]);
      expect(svg, key).toContain('NVIDIA H200');
    }
  });
});

test('no figures at all, one point, and ranges of nine powers of ten are drawn', () => {
  const runs = [
    madeUpRun([10], { deferred: [null] }),
    madeUpRun([10], { deferred: ['Lost its context.'] }),
    madeUpRun([0], { deferred: [1] }, 'shadows'),
    madeUpRun([1, 1e6], { deferred: [1e-3, 1e6], forward: [Number.NaN, -1] }),
  ];
  for (const run of runs) {
    for (const scale of ['log', 'linear'] as const) {
      const files = filesOf([run], { ...defaultSettings, scale });
      expect(files.length).toBeGreaterThan(0);
      for (const { svg } of files) {
        expect(svg).not.toMatch(/NaN|undefined|Infinity/);
      }
    }
  }
});

test('a series without a figure says so in its place', () => {
  const [{ svg }] = filesOf([madeUpRun([10], { deferred: ['Lost its context.'] })]);
  expect(svg).toContain('No figures here');
});

test('the thesis is compared in a file for each forward renderer', () => {
  const files = chartFiles(sampleRun({ preset: 'thesis' }));
  expect(files.map(({ name }) => name).filter((name) => name.startsWith('thesis'))).toEqual([
    'thesis-three-naive-multipass',
    'thesis-farol-forward',
    'thesis-farol-forward-single-pass',
    'thesis-three-webglrenderer',
  ]);
  const [multipass, forward] = files.filter(({ name }) => name.startsWith('thesis'));
  expect(multipass.svg).toContain('>three: naive multipass</text>');
  expect(forward.svg).not.toContain('naive multipass');
  expect(new Set(files.map(({ name }) => name)).size).toBe(files.length);
});

test('texts that others wrote cannot leave their place in a file', () => {
  const run = madeUpRun([10], { deferred: [1] });
  run.surroundings.device = '</text><script>alert(1)</script>';
  const [{ svg }] = filesOf([run]);
  expect(svg).not.toContain('<script');
  expect(svg).toContain('&lt;script');
});

test('passes that a software rasteriser timed are not called GPU time', () => {
  const run = sampleRun({ software: true });
  const { title, description } = passChart(run, defaultSettings)!;
  expect(`${title} ${description}`).not.toContain('GPU');
});

test('a pass has one colour in the charts of two runs, also where the first has other passes', () => {
  const one = madeUpRun([10], { deferred: [2] });
  const passes = (...names: string[]) => ({ kind: 'gpu', passes: names.map((name) => ({ name, ms: 1 })) }) as const;
  const withPasses = (...names: string[]): LabRun => ({ ...one, rows: [{ ...one.rows[0], passes: passes(...names) }] });
  const runs = [withPasses('lists', 'G-buffer'), withPasses('G-buffer', 'tiles')];
  const colours = chartsOf(runs, defaultSettings)
    .filter(({ key }) => key.startsWith('passes'))
    .map(({ keys }) => keys!.map(({ label, colour }) => [label, colour(paintOf('dark'))]));
  const [first, second] = colours.map((list) => Object.fromEntries(list) as Record<string, string>);
  expect([Object.keys(first), Object.keys(second)]).toEqual([
    ['lists', 'G-buffer'],
    ['G-buffer', 'tiles'],
  ]);
  expect(second['G-buffer']).toBe(first['G-buffer']);
  expect(new Set([...Object.values(first), second.tiles]).size).toBe(3);
});
