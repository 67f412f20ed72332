interface Changes {
  id: string;
  name: string;
  device: string;
  /** Factor of the frame times. */
  factor: number;
}

/** A run as exported by another machine's Lab: the atrium under 10 and 100 lights, by two competitors. */
export function labRun({ id, name, device, factor }: Changes) {
  const size = {
    shadows: 0,
    overdraw: 0,
    width: 640,
    height: 360,
    lightKind: 'points',
    lightRange: null,
    shading: 'own',
  };
  const spread = (median: number) => ({ median, low: median * 0.9, high: median * 1.1, samples: 30 });
  const row = (competitor: string, index: number, ms: number) => ({
    ...{ competitor, series: 'sponza-lights', index, frame: spread(ms * factor), cpu: spread(0.4), gpu: null },
    ...{ firstMs: 90, added: null, changed: null, passes: null, technique: null, reason: null, problem: null },
    counts: { draws: 101, triangles: 254_000, programs: 3, targetBytes: 1e6, uploadBytes: 3200 },
    likeness: { reference: 'forward', psnr: competitor === 'forward' ? null : 51.5, thumbnail: '' },
    ...{ dropped: 0, warnings: [] },
  });
  return {
    ...{ format: 'farol-lab-run', version: 1, id, name },
    surroundings: {
      ...{ date: '2026-11-22T18:00:00.000Z', device, browser: 'Chromium 156', system: 'Linux', cores: 8 },
      ...{ build: '0.1.0 (1234567)', versions: { three: '0.187.0' }, command: null, warnings: [] },
    },
    plan: {
      ...{ preset: 'custom', label: 'Custom', competitors: ['forward', 'deferred'] },
      series: [
        {
          ...{ name: 'sponza-lights', label: 'Atrium over point lights', axis: 'lights', values: [10, 100] },
          cases: [10, 100].map((lights) => ({ ...size, scene: { name: 'sponza', parameters: {} }, lights })),
        },
      ],
      effort: { rounds: 3, turn: 150, changes: false, longestFrame: 2000, limit: null },
    },
    rows: [row('forward', 0, 2), row('deferred', 0, 3), row('forward', 1, 20), row('deferred', 1, 5)],
    ...{ complete: true, duration: 9000 },
  };
}

/** A run as a file for an input or a drop. */
export const runFile = (name: string, run: object) => ({
  name,
  mimeType: 'application/json',
  buffer: Buffer.from(JSON.stringify(run)),
});
