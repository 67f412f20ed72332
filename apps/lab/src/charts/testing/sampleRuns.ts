import { competitorNames } from '../../competitors/competitorNames';
import type { LabCase } from '../../plan/LabPlan';
import { planOf } from '../../plan/planOf';
import { presets } from '../../plan/presets';
import type { LabRow, LabRun, Spread } from '../../results/LabRun';
import { isTechnique } from '../../words/names';

export interface SampleOptions {
  /** Key in `presets`; default `quick`. */
  readonly preset?: string;
  readonly competitors?: readonly string[];
  /** Whether a software rasteriser draws; it has timers too. Default false. */
  readonly software?: boolean;
}

/** A complete run of a preset with made-up times, for tests. */
export function sampleRun(options: SampleOptions = {}): LabRun {
  const { preset = 'quick', competitors = Object.keys(competitorNames), software = false } = options;
  const plan = planOf({ ...presets[preset].configuration, competitors });
  const rows = plan.series.flatMap(({ name, cases }) =>
    cases.flatMap((labCase, index) => rowsOf(name, index, labCase, competitors)),
  );
  return {
    ...{ format: 'farol-lab-run', version: 1, id: `sample-${preset}`, name: '', complete: true, duration: 88_000 },
    surroundings: {
      device: software
        ? 'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)'
        : 'ANGLE (NVIDIA, NVIDIA H200 (0x00002335), OpenGL ES 3.2)',
      ...{ date: '2026-11-22T18:00:00.000Z', browser: 'Chromium 156', system: 'Linux', cores: 16, build: '0.1.0' },
      ...{ versions: { three: '0.187.0' }, command: null, warnings: [] },
    },
    ...{ plan, rows },
  };
}

/** Rows of a case. Competitors later in the list cost more per frame and less per light. */
function rowsOf(series: string, index: number, labCase: LabCase, competitors: readonly string[]): LabRow[] {
  const megapixels = (labCase.width * labCase.height) / 1e6;
  const rows = competitors.map((competitor, i) => {
    const ms = 0.2 + 0.05 * i + (megapixels * (labCase.lights ?? 50)) / (3 + i) ** 2;
    return rowOf(competitor, series, index, ms);
  });
  const best = rows
    .filter(({ competitor }) => isTechnique(competitor))
    .sort((a, b) => a.frame!.median - b.frame!.median);
  const auto = rows.find(({ competitor }) => competitor === 'auto');
  if (auto && best.length > 0) Object.assign(auto, { technique: best[0].competitor, reason: 'by the lights in view' });
  return rows;
}

function rowOf(competitor: string, series: string, index: number, ms: number): LabRow {
  const passes = ['lists of lights', 'G-buffer', 'lights', 'output'].map((name, i) => ({ name, ms: ms / (i + 2) }));
  return {
    ...{ competitor, series, index, frame: spreadOf(ms), cpu: spreadOf(ms / 8), gpu: spreadOf(ms * 0.9) },
    ...{ firstMs: 60 + ms, added: { ms: ms * 1.15, programs: 0 }, changed: { ms: ms + 4, programs: 2 } },
    counts: { draws: 100, triangles: 254_000, programs: 6, targetBytes: 22e6, uploadBytes: 6400 },
    passes: isTechnique(competitor) ? { kind: 'gpu', passes } : null,
    likeness: { reference: 'forward', psnr: competitor === 'forward' ? null : 50, thumbnail: '' },
    ...{ dropped: 0, technique: null, reason: null, problem: null, warnings: [] },
  };
}

const spreadOf = (median: number): Spread => ({ median, low: median * 0.95, high: median * 1.1, samples: 24 });
