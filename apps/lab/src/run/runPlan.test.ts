import { describe, expect, it } from 'vitest';
import type { LabPlan } from '../plan/LabPlan';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import type { LabSurroundings } from '../results/LabRun';
import type { Stage } from '../stage/Stage';
import { Forecast } from './Forecast';
import type { Progress } from './Progress';
import { runPlan } from './runPlan';

const surroundings: LabSurroundings = {
  ...{ date: '2026-01-02T03:04:05.000Z', device: 'a device', browser: 'a browser', system: 'a system', cores: 2 },
  ...{ build: '', versions: {}, command: null, warnings: [] },
};

/** A stage whose competitors take a fixed time per frame (ms), and which records its calls. */
function fakeStage(times: Record<string, number>, said: string[]) {
  let clock = 0;
  const alive = new Set<string>();
  let most = 0;
  const spend = (ms: number): number => (clock += ms);
  const picture = (shade: number) =>
    ({ width: 2, height: 1, data: new Uint8ClampedArray([shade, 0, 0, 255, 9, 9, 9, 255]) }) as ImageData;
  const stage: Stage = {
    async open(name, { lights }) {
      said.push(`open ${name} ${lights}`);
      if (!(name in times)) throw new Error(`${name} cannot be opened.`);
      alive.add(name);
      most = Math.max(most, alive.size);
      spend(times[name] * 10);
      return {
        ...{ firstMs: times[name] * 10, dropped: name === 'babylon' ? 3 : 0, technique: null, reason: null },
        picture: picture(name === 'deferred' ? 101 : 100),
      };
    },
    async turn(name, ms) {
      said.push(`turn ${name}`);
      spend(Math.max(ms, 3 * times[name]));
      return { frame: [times[name], times[name]], cpu: [1], gpu: null };
    },
    count: async () => ({ draws: 1, triangles: 1, programs: 1, targetBytes: 1, uploadBytes: 1 }),
    passes: async () => null,
    addLights: async () => ({ ms: 5, programs: 0 }),
    changeTechnique: async () => null,
    close: (name) => void (said.push(`close ${name}`), alive.delete(name)),
    unavailable: async (name) => (name === 'three-webgpu' ? 'No WebGPU here.' : null),
    setOwnScene: async () => {},
    device: async () => ({ renderer: 'a device', timer: false, software: false, webgpu: null }),
  };
  const frames = { stageOf: async () => stage, close: () => {} };
  return { frames, now: () => clock, most: () => most, alive };
}

function smallPlan(competitors: string[], changes: Partial<LabPlan['effort']> = {}): LabPlan {
  const { configuration } = presets.lights;
  const effort = { ...configuration.effort, rounds: 2, turn: 100, ...changes };
  const series = [{ ...configuration.series[0], values: [10, 100] }];
  return planOf({ ...configuration, series, competitors, effort });
}

const options = (stage: ReturnType<typeof fakeStage>) => ({
  ...{ frames: stage.frames, now: stage.now, surroundings, signal: new AbortController().signal },
  thumbnailOf: () => '',
});

describe('runPlan', () => {
  it('gives competitors turns one after the other, and closes them all', async () => {
    const said: string[] = [];
    const stage = fakeStage({ stock: 1, deferred: 2 }, said);
    const run = await runPlan(smallPlan(['stock', 'deferred']), options(stage));
    expect(said.slice(0, 8)).toEqual([
      ...['open stock 10', 'open deferred 10', 'turn stock', 'turn deferred', 'turn stock', 'turn deferred'],
      ...['close stock', 'close deferred'],
    ]);
    expect(stage.alive.size).toBe(0);
    expect(run.complete).toBe(true);
    expect(run.rows.map(({ competitor, index, frame }) => [competitor, index, frame?.median])).toEqual([
      ...[['stock', 0, 1] as const, ['deferred', 0, 2] as const],
      ...[['stock', 1, 1] as const, ['deferred', 1, 2] as const],
    ]);
    expect(run.rows[0].frame?.samples).toBe(4);
  });

  it('waits after each case for what is done with its rows', async () => {
    const said: string[] = [];
    const stage = fakeStage({ stock: 1 }, said);
    const onCase = async ({ rows }: Progress): Promise<void> => {
      said.push(`rows ${rows.length}, begun`);
      for (let i = 0; i < 5; i++) await Promise.resolve();
      said.push('ended');
    };
    await runPlan(smallPlan(['stock']), { ...options(stage), onCase });
    const turns = ['turn stock', 'turn stock', 'close stock'];
    expect(said).toEqual([
      ...['open stock 10', ...turns, 'rows 1, begun', 'ended'],
      ...['open stock 100', ...turns, 'rows 2, begun', 'ended'],
    ]);
  });

  it('compares pictures with stock three’s', async () => {
    const stage = fakeStage({ stock: 1, deferred: 2, forward: 2 }, []);
    const { rows } = await runPlan(smallPlan(['deferred', 'forward', 'stock']), options(stage));
    expect(rows[0].likeness).toMatchObject({ reference: 'stock', psnr: expect.closeTo(10 * Math.log10(255 ** 2 * 6)) });
    expect(rows[1].likeness).toMatchObject({ reference: 'stock', psnr: null });
  });

  it('draws the reference by a competitor that is not measured, and closes it', async () => {
    const said: string[] = [];
    const stage = fakeStage({ stock: 1, deferred: 2 }, said);
    const { rows } = await runPlan(smallPlan(['deferred']), options(stage));
    expect(rows).toHaveLength(2);
    expect(rows[0].likeness?.reference).toBe('stock');
    expect(said).toContain('close stock');
    expect(said).not.toContain('turn stock');
  });

  it('names what cannot be measured, and measures the rest', async () => {
    const stage = fakeStage({ deferred: 2, babylon: 4 }, []);
    const run = await runPlan(smallPlan(['stock', 'three-webgpu', 'deferred', 'babylon']), options(stage));
    const [stock, webgpu, deferred, babylon] = run.rows;
    expect(stock.problem).toBe('stock cannot be opened.');
    expect(webgpu.problem).toBe('No WebGPU here.');
    expect(deferred.frame?.median).toBe(2);
    expect(babylon.dropped).toBe(3);
    expect(babylon.warnings.join()).toContain('3 lights are left out');
  });

  it('measures what changes cost in each case, and in the first of a series where the run has a limit', async () => {
    const added = async (limit: number | null): Promise<(number | undefined)[]> => {
      const plan = smallPlan(['deferred'], { changes: true, limit });
      const { rows } = await runPlan(plan, options(fakeStage({ deferred: 2 }, [])));
      return rows.map((row) => row.added?.ms);
    };
    expect(await added(null)).toEqual([5, 5]);
    expect(await added(80_000)).toEqual([5, undefined]);
  });

  it('leaves out what would take too long, by its growth', async () => {
    const stage = fakeStage({ stock: 400, deferred: 2 }, []);
    const run = await runPlan(smallPlan(['stock', 'deferred'], { longestFrame: 3000 }), options(stage));
    const [, , stock, deferred] = run.rows;
    expect(stock.problem).toMatch(/^Left out: its first frame would take about 7\.6 s/);
    expect(deferred.problem).toBeNull();
  });

  it('ends within its limit by shorter turns, and says what it left out', async () => {
    const stage = fakeStage({ stock: 100, deferred: 100 }, []);
    const plan = smallPlan(['stock', 'deferred'], { limit: 3000 });
    const run = await runPlan(plan, options(stage));
    expect(run.complete).toBe(false);
    expect(run.rows.at(-1)?.problem).toMatch(/limit of 3 s/);
  });

  it('gives no turn once its time is up in the midst of a case, but for the first', async () => {
    const said: string[] = [];
    const stage = fakeStage({ stock: 100, deferred: 100 }, said);
    const run = await runPlan(smallPlan(['stock', 'deferred'], { limit: 4000 }), options(stage));
    // the second case begins in time, but opening its first competitor uses up the rest
    expect(said.slice(said.lastIndexOf('open stock 100'))).toEqual(['open stock 100', 'close stock']);
    expect(run.rows.slice(2).map(({ problem }) => problem)).toEqual([
      'Not measured: the run’s limit of 4 s was reached.',
      'Not measured: the run’s limit of 4 s was reached.',
    ]);
    expect(run.complete).toBe(false);
    const short = await runPlan(smallPlan(['stock'], { limit: 1 }), options(fakeStage({ stock: 100 }, [])));
    expect(short.rows[0].frame?.median).toBe(100);
  });

  it('keeps what is there when it is cancelled', async () => {
    const stage = fakeStage({ stock: 1, deferred: 2 }, []);
    const cancel = new AbortController();
    let steps = 0;
    const run = await runPlan(smallPlan(['stock', 'deferred']), {
      ...options(stage),
      signal: cancel.signal,
      onProgress: () => void (++steps === 6 && cancel.abort()),
    });
    expect(run.complete).toBe(false);
    expect(run.rows).toHaveLength(2);
    expect(run.rows[0].frame?.median).toBe(1);
    expect(stage.alive.size).toBe(0);
  });

  it('keeps no more contexts than a browser does', async () => {
    const stage = fakeStage({ a: 1, b: 1, c: 1, d: 1, stock: 1 }, []);
    const run = await runPlan(smallPlan(['a', 'b', 'c', 'd']), { ...options(stage), mostContexts: 3 });
    expect(stage.most()).toBe(2);
    expect(run.rows.filter(({ frame }) => frame)).toHaveLength(8);
  });

  it('warns of a competitor that becomes slower from turn to turn', async () => {
    const times = { stock: 1, deferred: 1 };
    const stage = fakeStage(times, []);
    const run = await runPlan(smallPlan(['deferred']), {
      ...options(stage),
      onProgress: ({ done }) => void (times.deferred = done ** 2),
    });
    expect(run.rows[0].warnings.join()).toContain('slower than the first');
  });
});

describe('Forecast', () => {
  it('takes programs of a first frame for the same in the next case, until two cases show how they grow', () => {
    const forecast = new Forecast(10_000);
    const note = (value: number, first: number, frame: number): void => {
      forecast.note('atrium', 'multipass', 'first', value, first);
      forecast.note('atrium', 'multipass', 'frame', value, frame);
    };
    note(4, 3000, 10);
    expect(forecast.refuses('atrium', 'multipass', 144)).toBeNull();
    expect(forecast.refuses('atrium', 'multipass', 40_000)).toContain('its first frame would take about 103 s');
    note(8, 6000, 20);
    expect(forecast.refuses('atrium', 'multipass', 16)).toContain('about 12 s');
    expect(forecast.refuses('atrium', 'stock', 16)).toBeNull();
  });
});

describe('planOf', () => {
  it('makes the rows of the thesis’s three tables', () => {
    const { series } = planOf(presets.thesis.configuration);
    const rows = series.flatMap(({ cases }) =>
      cases.map(({ scene, lights }) => [scene.name, scene.parameters.n, lights]),
    );
    expect(rows).toHaveLength(21);
    expect(rows.slice(0, 9)).toEqual([
      ...[1, 4, 25, 100, 225].map((lights) => ['benchmarkLights', 1, lights]),
      ...[2, 5, 10, 15].map((n) => ['benchmarkLights', n, n * n]),
    ]);
  });

  it('names what it does not know', () => {
    const { configuration } = presets.lights;
    const wrong = (changes: object) => () =>
      planOf({ ...configuration, series: [{ ...configuration.series[0], ...changes }] });
    expect(wrong({ scene: 'nowhere' })).toThrow('Unknown scene nowhere: choose one of benchmarkLights, sponza');
    expect(wrong({ axis: 'objects' })).toThrow('Atrium cannot be measured over objects');
    expect(wrong({ values: [Number.NaN] })).toThrow('NaN is not a value for lights');
    expect(() => planOf({ ...configuration, competitors: [] })).toThrow('choose at least one competitor');
  });

  it('keeps the sides’ ratio over pixels, and sorts values', () => {
    const { configuration } = presets.resolution;
    const [{ cases, values }] = planOf({
      ...configuration,
      series: [{ ...configuration.series[0], values: [922, 230] }],
    }).series;
    expect(cases.map(({ width, height }) => [width, height])).toEqual([
      [639, 360],
      [1280, 720],
    ]);
    expect(values).toEqual([639 * 360, 1280 * 720]);
  });
});
