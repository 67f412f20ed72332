import { setTexts } from '@farol/editing';
import { expect, test } from 'vitest';
import { es } from '../language/es';
import { sampleRun } from '../charts/testing/sampleRuns';
import { exactly } from '../words/testing/madeUpRun';
import { compareThesis } from './compareThesis';
import { defaultSettings } from '../charts/ChartSpec';
import { paintOf } from '../charts/chartPaint';
import { thesisChart } from './thesisChart';
import { thesis2015 } from './thesis2015';

test('the tables have 21 rows, and the thesis preset has a case for each', () => {
  expect(thesis2015).toHaveLength(21);
  const pairs = compareThesis(sampleRun({ preset: 'thesis' }), 'frame');
  expect(pairs.filter(({ of }) => of === null)).toEqual([]);
  const cases = pairs.map(({ of }) => `${of!.series.name} ${of!.index}`);
  expect(new Set(cases).size).toBe(21);
});

test('rows are named in the language that is shown', () => {
  setTexts(es, 'es');
  const labels = compareThesis(sampleRun({ preset: 'thesis' }), 'frame').map(({ label }) => label);
  setTexts({});
  expect(labels).toContain('1 plano, 4 luces');
  expect(labels.filter((label) => /light|plane/.test(label))).toEqual([]);
});

test('shadows and layers are no rows of the thesis', () => {
  const { plan, ...run } = sampleRun({ preset: 'thesis' });
  const matched = (changes: { shadows?: number; overdraw?: number }): number => {
    const series = plan.series.map((each) => ({ ...each, cases: each.cases.map((one) => ({ ...one, ...changes })) }));
    return compareThesis({ ...run, plan: { ...plan, series } }, 'frame').filter(({ of }) => of !== null).length;
  };
  expect([matched({}), matched({ shadows: 1 }), matched({ overdraw: 2 })]).toEqual([21, 0, 0]);
});

test('forward is drawn by the thesis’s own algorithm first, and by single pass too', () => {
  const names = ['forward', 'stock', 'multipass', 'forward-single-pass', 'deferred', 'auto'];
  const chart = thesisChart(sampleRun({ preset: 'thesis', competitors: names }), defaultSettings)!;
  expect(chart.choice!.options).toEqual([
    ...['three: naive multipass', 'Farol: forward', 'Farol: forward, single pass', 'three: WebGLRenderer'],
  ]);
  expect(chart.choice!.selected).toBe(0);
});

test('a row without data is no heading: tables’ names alone are bold', () => {
  const run = sampleRun({ preset: 'thesis', competitors: ['forward', 'deferred'] });
  for (const row of run.rows) Object.assign(row, { frame: null, problem: 'A frame would take longer than 2 s.' });
  Object.assign(
    run.rows.find(({ competitor }) => competitor === 'deferred')!,
    { frame: exactly(10), problem: null },
  );
  const { svg } = thesisChart(run, defaultSettings)!.draw({ width: 800, paint: paintOf('dark') });
  expect(svg.match(/font-weight="bold"/g)).toHaveLength(3);
});
