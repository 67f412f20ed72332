import { describe, expect, test } from 'vitest';
import { sampleRun } from '../charts/sampleRuns';
import type { LabRun, Spread } from '../results/LabRun';
import { exactly } from '../words/madeUpRun';
import { compareThesis } from './compareThesis';
import { defaultSettings } from '../charts/ChartSpec';
import { paintOf } from '../charts/chartPaint';
import { SvgDocument } from '../charts/SvgDocument';
import { thesisChart } from './thesisChart';
import { conclusionsOf } from './conclusions';
import { thesis2015 } from './thesis2015';

type Time = Spread | number | null;

/** A run of the thesis preset in which two competitors take what a function of planes and lights says. */
function thesisRun(
  times: (planes: number, lights: number, scene: string) => { forward: Time; deferred: Time },
): LabRun {
  const run = sampleRun({ preset: 'thesis', competitors: ['forward', 'deferred'] });
  for (const row of run.rows) {
    const labCase = run.plan.series.find(({ name }) => name === row.series)!.cases[row.index];
    const planes = labCase.scene.name === 'benchmarkLights' ? Number(labCase.scene.parameters.n) ** 2 : 0;
    const time = times(planes, labCase.lights!, labCase.scene.name)[row.competitor as 'forward' | 'deferred'];
    row.frame = typeof time === 'number' ? exactly(time) : time;
    row.passes = null;
    row.problem = time === null ? 'A frame would take longer than 2 s.' : null;
  }
  return run;
}

const verdictsOf = (run: LabRun): string[] =>
  conclusionsOf(run, compareThesis(run, 'frame')).map(({ verdict }) => verdict);

test('the tables have 21 rows, and the thesis preset has a case for each', () => {
  expect(thesis2015).toHaveLength(21);
  const pairs = compareThesis(sampleRun({ preset: 'thesis' }), 'frame');
  expect(pairs.filter(({ of }) => of === null)).toEqual([]);
  const cases = pairs.map(({ of }) => `${of!.series.name} ${of!.index}`);
  expect(new Set(cases).size).toBe(21);
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
  const run = thesisRun(() => ({ forward: null, deferred: null }));
  Object.assign(
    run.rows.find(({ competitor }) => competitor === 'deferred')!,
    { frame: exactly(10), problem: null },
  );
  const document = new SvgDocument() as unknown as Document;
  const { svg } = thesisChart(run, defaultSettings)!.draw({ width: 800, paint: paintOf('dark'), document });
  expect(svg.outerHTML.match(/font-weight="bold"/g)).toHaveLength(3);
});

describe('conclusions', () => {
  test('times as in 2015 confirm all of them', () => {
    const middle = ([low, high]: readonly [number, number]) => 2000 / (low + high);
    const run = thesisRun((planes, lights, scene) => {
      const table = scene === 'benchmarkLights' ? 'planes' : scene;
      const row = thesis2015.find((each) => each.table === table && each.planes === planes && each.lights === lights)!;
      return {
        forward: row.forward && middle(row.forward),
        deferred: row.deferred && middle(row.deferred),
      };
    });
    expect(verdictsOf(run)).toEqual(Array.from({ length: 7 }, () => 'Confirmed'));
  });

  test('forward that always wins refutes them', () => {
    const run = thesisRun((_, lights) => ({ forward: 0.1 + lights * 1e-3, deferred: 0.2 + lights * 1e-2 }));
    expect(verdictsOf(run)).toEqual([
      ...['Confirmed', 'Refuted', 'Refuted', 'Refuted', 'Confirmed', 'Refuted', 'Refuted'],
    ]);
  });

  test('times that tie decide nothing', () => {
    const wide = { median: 5, low: 2, high: 9, samples: 9 };
    const run = thesisRun(() => ({ forward: wide, deferred: { ...wide, median: 5.5 } }));
    expect(verdictsOf(run)).toEqual([
      ...['Undecided', 'Undecided', 'Undecided', 'Undecided', 'Undecided', 'Refuted', 'Refuted'],
    ]);
  });

  test('deferred that is faster with one light over one plane has no cost that shows', () => {
    const run = thesisRun((_, lights) => ({ forward: lights + 1, deferred: 1 }));
    expect(verdictsOf(run)[4]).toBe('Refuted');
  });

  test('growth within the spreads is unsure', () => {
    const spread = (median: number) => ({ median, low: median * 0.4, high: median * 2.5, samples: 9 });
    const run = thesisRun((_, lights) => ({ forward: spread(lights), deferred: spread(5 + lights * 0.5) }));
    const growth = conclusionsOf(run, compareThesis(run, 'frame'))[3];
    expect(growth.verdict).toBe('Undecided');
    expect(growth.evidence).toContain('which the spread makes unsure');
  });

  test('missing figures decide nothing, and the evidence says so', () => {
    const run = thesisRun(() => ({ forward: null, deferred: null }));
    const conclusions = conclusionsOf(run, compareThesis(run, 'frame'));
    expect(new Set(conclusions.map(({ verdict }) => verdict))).toEqual(new Set(['Undecided']));
    expect(conclusions[0].evidence).toBe('The rows that would decide have no figures.');
  });

  test('the figures that decide stand in the evidence', () => {
    const run = thesisRun((planes, lights) => ({ forward: lights, deferred: planes === 1 ? 20 : 5 }));
    const [few, many] = conclusionsOf(run, compareThesis(run, 'frame'));
    expect(few.verdict).toBe('Confirmed in part');
    expect(few.evidence).toContain('1 plane, 25 lights: forward 25 ms, deferred 20 ms');
    expect(many.evidence).toBe(
      '1 plane, 100 lights: forward 100 ms, deferred 20 ms; 1 plane, 225 lights: forward 225 ms, deferred 20 ms.',
    );
  });

  test('forward that falls behind in one scene alone does not refute what deferred reaches there', () => {
    const run = thesisRun((_, lights, scene) => ({
      forward: scene === 'sponza' && lights > 200 ? 100 : 20,
      deferred: 5,
    }));
    expect(conclusionsOf(run, compareThesis(run, 'frame')).at(-1)).toMatchObject({
      verdict: 'Confirmed in part',
      evidence:
        '15 frames a second in the atrium: deferred up to 500 lights, forward up to 200 lights; in the temple: deferred up to 500 lights, forward up to 500 lights.',
    });
  });

  test('a G-buffer that grows with the lights is no fixed cost', () => {
    const run = thesisRun((_, lights) => ({ forward: lights, deferred: lights + 2 }));
    for (const row of run.rows) {
      row.passes = {
        kind: 'gpu',
        passes: [
          { name: 'G-buffer', ms: 0.5 },
          { name: 'lights', ms: 1 },
        ],
      };
    }
    const verdict = () => conclusionsOf(run, compareThesis(run, 'frame'))[4];
    expect(verdict()).toMatchObject({ verdict: 'Confirmed' });
    expect(verdict().evidence).toContain('Its G-buffer takes 0.5 ms from 1 to 225 lights.');
    for (const row of run.rows) row.passes!.passes[0].ms = 0.1 * (row.index + 1);
    expect(verdict()).toMatchObject({ verdict: 'Confirmed in part' });
  });
});
