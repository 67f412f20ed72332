import { describe, expect, it } from 'vitest';
import { compareRuns } from './compareRuns';
import { testRun } from './testing/testRun';

/** A run on another machine: `deferred` takes half the time, `forward` twice. */
function elsewhere() {
  const run = testRun({ id: 'elsewhere' });
  for (const row of run.rows) {
    const factor = row.competitor === 'deferred' ? 0.5 : 2;
    for (const kind of ['frame', 'gpu', 'cpu'] as const) row[kind]!.median *= factor;
  }
  return run;
}

describe('compareRuns', () => {
  it('has a ratio for each case and competitor, and a geometric mean for each competitor', () => {
    const { metric, rows, competitors, differences } = compareRuns(testRun(), elsewhere());
    expect(metric).toBe('gpu');
    expect(rows.map(({ competitor, value, ratio }) => [competitor, value, ratio])).toEqual([
      ['forward', 4, 0.5],
      ['deferred', 4, 2],
      ['forward', 100, 0.5],
      ['deferred', 100, 2],
      ['forward', 230_400, 0.5],
      ['deferred', 230_400, 2],
    ]);
    expect(competitors).toEqual([
      { competitor: 'forward', ratio: expect.closeTo(0.5, 12), cases: 3 },
      { competitor: 'deferred', ratio: expect.closeTo(2, 12), cases: 3 },
    ]);
    expect(differences).toEqual([]);
  });

  it('takes cases of other lights or another shading for other cases', () => {
    const b = elsewhere();
    const [planes, atrium] = b.plan.series;
    const cases = planes.cases.map((each) => ({ ...each, lightKind: 'field' as const }));
    const flat = atrium.cases.map((each) => ({ ...each, shading: 'flat' as const }));
    const plan = {
      ...b.plan,
      series: [
        { ...planes, cases },
        { ...atrium, cases: flat },
      ],
    };
    expect(compareRuns(testRun(), { ...b, plan }).rows).toEqual([]);
  });

  it('takes the mean of the logarithms: twice and half make one', () => {
    const b = elsewhere();
    b.rows[0].gpu!.median = 4; // ratio 0.5 / 4
    b.rows[2].gpu!.median = 10; // ratio 10 / 10
    b.rows[4].gpu!.median = 0.5; // ratio 4 / 0.5
    expect(compareRuns(testRun(), b).competitors[0].ratio).toBeCloseTo(1, 12);
  });

  it('compares throughput where a run has no GPU time', () => {
    const b = elsewhere();
    b.rows[5].gpu = null;
    const { metric, rows } = compareRuns(testRun(), b);
    expect(metric).toBe('frame');
    expect(rows[5]).toMatchObject({ a: 3, b: 1.5, ratio: 2 });
  });

  it('has no ratio where a run has no figure, and leaves it out of the mean', () => {
    const b = elsewhere();
    Object.assign(b.rows[0], { frame: null, cpu: null, gpu: null, problem: 'Too many lights.' });
    const { rows, competitors } = compareRuns(testRun(), b);
    expect(rows[0]).toMatchObject({ a: 0.5, b: null, ratio: null });
    expect(competitors[0]).toMatchObject({ cases: 2 });
  });

  it('finds cases by what they draw, and says what the runs differ in', () => {
    const b = elsewhere();
    const [planes, atrium] = b.plan.series;
    const more = {
      ...atrium,
      cases: [{ ...atrium.cases[0], width: 800, height: 450 }, ...atrium.cases],
      values: [1, 2],
    };
    b.plan = { ...b.plan, series: [more, planes], competitors: ['forward', 'deferred', 'stock'] };
    for (const row of b.rows) if (row.series === 'sponza-pixels') row.index = 1;
    b.plan = { ...b.plan, effort: { ...b.plan.effort, rounds: 1 } };
    b.complete = false;
    Object.assign(b.surroundings, {
      build: '0.2.0',
      browser: 'Firefox 150',
      versions: { three: '0.190.0', playcanvas: '2' },
    });
    const { rows, differences } = compareRuns(testRun(), b);
    expect(rows).toHaveLength(6);
    expect(differences).toEqual([
      'One case of the second run alone is left out.',
      'Only the second run measured stock.',
      'They took 3 turns of 150 ms and 1 of 150 ms.',
      'The builds of Farol differ: 0.1.0 (922d2a6) and 0.2.0.',
      'They have three 0.187.0 and 0.190.0.',
      'The browsers differ: Chromium 156 and Firefox 150.',
      'The second run ended before every case was measured.',
    ]);
  });

  it('says so when the same cases were drawn at other sizes', () => {
    const b = elsewhere();
    const small = b.plan.series.map((each) => ({
      ...each,
      cases: each.cases.map((labCase) => ({ ...labCase, width: 160, height: 90 })),
    }));
    b.plan = { ...b.plan, series: small };
    expect(compareRuns(testRun(), b).differences[0]).toBe(
      'No picture has the same size in both runs: measure both at one size.',
    );
  });

  it('says so when nothing can be compared', () => {
    const b = elsewhere();
    b.plan = { ...b.plan, competitors: ['stock'] };
    b.rows = [];
    const { rows, competitors, differences } = compareRuns(testRun(), b);
    expect(rows).toEqual([]);
    expect(competitors).toEqual([]);
    expect(differences[0]).toMatch(/no case and competitor in common/);
  });
});
