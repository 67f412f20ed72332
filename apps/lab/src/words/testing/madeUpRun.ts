import { type Axis, type LabSeries, plainCase } from '../../plan/LabPlan';
import { lightKindNames, shadingNames } from '../../plan/lightKinds';
import type { LabRow, LabRun, Spread } from '../../results/LabRun';

/** A time without spread. */
export const exactly = (median: number): Spread => ({ median, low: median, high: median, samples: 9 });

/** A row with only a frame time, or with a problem; for tests. */
export function madeUpRow(competitor: string, index: number, time: number | Spread | string | null): LabRow {
  return {
    ...{ competitor, series: 'made-up', index },
    frame: typeof time === 'number' ? exactly(time) : typeof time === 'string' ? null : time,
    ...{ cpu: null, gpu: null, firstMs: null, added: null, changed: null, counts: null, passes: null, likeness: null },
    ...{ dropped: 0, technique: null, reason: null, warnings: [] },
    problem: typeof time === 'string' ? time : null,
  };
}

/** A series of cases of 1280 × 720 pixels in the atrium, named `made-up`. */
export function madeUpSeries(values: readonly number[], axis: Axis = 'lights'): LabSeries {
  const cases = values.map((value) => ({
    scene: { name: 'sponza', parameters: {} },
    lights: axis === 'lights' ? value : 100,
    ...{ shadows: axis === 'shadows' ? value : 0, overdraw: axis === 'overdraw' ? value : 0, width: 1280, height: 720 },
    lightKind: axis === 'kind' ? lightKindNames[value] : plainCase.lightKind,
    lightRange: null,
    shading: axis === 'shading' ? shadingNames[value] : plainCase.shading,
  }));
  return { name: 'made-up', label: 'Made up', axis, cases, values };
}

/** A run of one series, for tests: for each competitor and case a time, a problem, or null for no row. */
export function madeUpRun(
  values: readonly number[],
  times: Readonly<Record<string, readonly (number | Spread | string | null)[]>>,
  axis: Axis = 'lights',
): LabRun {
  const rows = Object.entries(times).flatMap(([competitor, list]) =>
    list.flatMap((time, index) => (time === null ? [] : [madeUpRow(competitor, index, time)])),
  );
  const effort = { rounds: 3, turn: 150, changes: false, longestFrame: 2000, limit: null };
  return {
    ...{ format: 'farol-lab-run', version: 1, id: 'made-up', name: '', complete: true, duration: 1000, rows },
    surroundings: {
      ...{ date: '2026-11-22T18:00:00.000Z', device: 'Made-up device', browser: 'Chromium 156', system: 'Linux' },
      ...{ cores: 4, build: '0.1.0', versions: {}, command: null, warnings: [] },
    },
    plan: {
      ...{ preset: 'custom', label: 'Custom', competitors: Object.keys(times), effort },
      series: [madeUpSeries(values, axis)],
    },
  };
}
