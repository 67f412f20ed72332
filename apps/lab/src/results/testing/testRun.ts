import { type LabPlan, plainCase } from '../../plan/LabPlan';
import type { LabRow, LabRun } from '../LabRun';

const spread = (median: number) => ({ median, low: median * 0.9, high: median * 1.2, samples: 30 });

/** A row with a value in every field, for tests. */
export function testRow(competitor: string, series: string, index: number, median: number): LabRow {
  return {
    ...{ competitor, series, index },
    ...{ frame: spread(median), cpu: spread(median / 4), gpu: spread(median / 2) },
    firstMs: 120,
    added: { ms: median * 1.5, programs: 0 },
    changed: { ms: 80, programs: 3 },
    counts: { draws: 100, triangles: 254_000, programs: 7, targetBytes: 14_745_600, uploadBytes: 6400 },
    passes: { kind: 'gpu', passes: [{ name: 'G-buffer', ms: median / 3 }] },
    likeness: { reference: 'forward', psnr: 51.5, thumbnail: 'data:image/webp;base64,UklGRg==' },
    ...{ dropped: 0, technique: null, reason: null, problem: null, warnings: [] },
  };
}

/** A run of two series, planes over lights and the atrium over pixels, by two competitors; for tests. */
export function testRun(changes: Partial<LabRun> = {}): LabRun {
  const size = { ...plainCase, shadows: 0, overdraw: 0, width: 1280, height: 720 };
  const planes = { name: 'benchmarkLights', parameters: { n: 1 } };
  const atrium = { name: 'sponza', parameters: {} };
  const plan: LabPlan = {
    preset: 'custom',
    label: 'Custom',
    series: [
      {
        ...{ name: 'planes-lights', label: 'Planes 1 × 1 over point lights', axis: 'lights', values: [4, 100] },
        cases: [4, 100].map((lights) => ({ ...size, scene: planes, lights })),
      },
      {
        ...{ name: 'sponza-pixels', label: 'Atrium over pixels, 20 lights', axis: 'pixels', values: [230_400] },
        cases: [{ ...size, scene: atrium, lights: 20, width: 640, height: 360 }],
      },
    ],
    competitors: ['forward', 'deferred'],
    effort: { rounds: 3, turn: 150, changes: true, longestFrame: 2000, limit: null },
  };
  return {
    ...{ format: 'farol-lab-run', version: 1, id: '2026-11-22-k3x9', name: 'Kitchen laptop' },
    surroundings: {
      ...{ date: '2026-11-22T18:00:00.000Z', device: 'ANGLE (Test, "GPU", Vulkan)', browser: 'Chromium 156' },
      ...{ system: 'Linux', cores: 8, build: '0.1.0 (922d2a6)', versions: { three: '0.187.0' } },
      ...{ command: null, warnings: [] },
    },
    plan,
    rows: [
      testRow('forward', 'planes-lights', 0, 1),
      testRow('deferred', 'planes-lights', 0, 2),
      testRow('forward', 'planes-lights', 1, 20),
      testRow('deferred', 'planes-lights', 1, 4),
      testRow('forward', 'sponza-pixels', 0, 8),
      testRow('deferred', 'sponza-pixels', 0, 3),
    ],
    ...{ complete: true, duration: 9000 },
    ...changes,
  };
}
