import { createRandom } from '@farol/engine';
import { competitorNames } from '../competitors/competitorNames';
import type { LabCase, LabPlan } from '../plan/LabPlan';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import type { LabRow, LabRun, Spread } from '../results/LabRun';

/** How a made-up run differs from an ordinary one. */
export interface SampleOptions {
  /** Key in `presets`. */
  preset?: string;
  seed?: number;
  competitors?: readonly string[];
  /** How much slower the device is than the ordinary one. */
  slowness?: number;
  software?: boolean;
  timer?: boolean;
  name?: string;
}

/** Made-up costs (ms): of a frame, of a light at a megapixel, of an object a light, of a megapixel. */
const costs: Readonly<Record<string, readonly [frame: number, light: number, pass: number, fill: number]>> = {
  forward: [0.1, 0.05, 0.0009, 0.25],
  'forward-single-pass': [0.1, 0.09, 0.0002, 0.25],
  deferred: [0.16, 0.015, 0, 0.7],
  'light-prepass': [0.2, 0.022, 0, 1.1],
  inferred: [0.25, 0.014, 0, 0.95],
  'tiled-deferred': [0.4, 0.0048, 0, 0.75],
  'tiled-forward': [0.38, 0.008, 0, 0.5],
  'forward-plus': [0.5, 0.0068, 0, 0.62],
  'clustered-deferred': [0.3, 0.0058, 0, 0.72],
  'clustered-forward': [0.28, 0.0078, 0, 0.4],
  stock: [0.08, 0.26, 0, 0.3],
  multipass: [0.1, 0.55, 0.004, 0.3],
  'three-webgpu': [0.5, 0.019, 0, 0.5],
  playcanvas: [0.4, 0.03, 0.0005, 0.6],
  babylon: [0.5, 0.088, 0, 0.6],
};

/** A run as a device might have given it, the same one for the same options. For tests and for looking at charts. */
export function sampleRun(options: SampleOptions = {}): LabRun {
  const { preset = 'quick', seed = 1, slowness = 1, software = false, timer = !software, name = '' } = options;
  const competitors = options.competitors ?? Object.keys(competitorNames);
  const plan: LabPlan = planOf({ ...presets[preset].configuration, competitors });
  const random = createRandom(seed);
  const rows: LabRow[] = [];
  for (const series of plan.series) {
    series.cases.forEach((labCase, index) => {
      const times = new Map(competitors.map((each) => [each, slowness * (software ? 90 : 1) * costOf(each, labCase)]));
      const choice = choiceOf(times, random);
      if (times.has('auto') && choice) times.set('auto', times.get(choice)! * 1.01);
      for (const competitor of competitors) {
        const ms = times.get(competitor)!;
        const row = rowOf(competitor, series.name, index, labCase, ms, { random, timer, software });
        if (competitor === 'auto' && choice) Object.assign(row, { technique: choice, reason: 'by what is in view' });
        if (!plan.effort.changes && preset !== 'changes') Object.assign(row, { added: null, changed: null });
        rows.push(row);
      }
    });
  }
  return {
    ...{ format: 'farol-lab-run', version: 1, id: `sample-${preset}-${seed}`, name },
    surroundings: {
      date: '2026-11-22T18:00:00.000Z',
      device: software
        ? 'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)'
        : 'ANGLE (NVIDIA, NVIDIA H200 (0x00002335), OpenGL ES 3.2)',
      ...{ browser: 'Chromium 156', system: 'Linux', cores: 16, build: '0.1.0', versions: { three: '0.187.0' } },
      command: null,
      warnings: software ? ['A software rasteriser drew: times are a processor’s, not a graphics device’s.'] : [],
    },
    ...{ plan, rows, complete: true, duration: 88_000 },
  };
}

function costOf(competitor: string, { lights, width, height, scene, overdraw, shadows }: LabCase): number {
  const [frame, light, pass, fill] = costs[competitor] ?? [0.3, 0.006, 0, 0.6];
  const megapixels = (width * height) / 921_600;
  const n = Number(scene.parameters.n ?? 10) ** 2;
  const count = lights ?? 50;
  const layers =
    /forward|stock|multipass/.test(competitor) && competitor !== 'forward-plus'
      ? 1 + overdraw * 0.6
      : 1 + overdraw * 0.15;
  const shading = light * count ** 0.97 * megapixels * layers;
  return frame + n * 0.0004 + shading + pass * n * Math.sqrt(count) + fill * megapixels * layers + shadows * 0.055;
}

function choiceOf(times: ReadonlyMap<string, number>, random: () => number): string | undefined {
  const own = [...times]
    .filter(([name]) => name !== 'auto' && competitorNames[name as keyof typeof competitorNames]?.kind === 'farol')
    .sort((a, b) => a[1] - b[1]);
  return own[random() < 0.8 ? 0 : Math.min(1, own.length - 1)]?.[0];
}

function rowOf(
  competitor: string,
  series: string,
  index: number,
  labCase: LabCase,
  ms: number,
  { random, timer, software }: { random: () => number; timer: boolean; software: boolean },
): LabRow {
  const lights = labCase.lights ?? 0;
  const noise = software ? 0.12 : 0.025;
  const frame = spreadOf(ms, noise, random);
  const gpu = timer && competitor !== 'three-webgpu' ? spreadOf(ms * 0.92, noise / 2, random) : null;
  const cpu = spreadOf(0.12 + ms * 0.05 + (competitor === 'multipass' ? lights * 0.08 : 0), 0.1, random);
  const compiles = competitor === 'stock';
  const farol = competitorNames[competitor as keyof typeof competitorNames]?.kind === 'farol';
  const row: LabRow = {
    ...{ competitor, series, index, frame, cpu, gpu },
    firstMs: 60 + ms + 120 * random() + (compiles ? lights * 8 : 0),
    added: { ms: ms * 1.15 + (compiles ? 90 + lights * 8 : 0), programs: compiles ? 3 : 0 },
    changed: farol ? { ms: ms * 1.3 + 4, programs: Math.round(2 + 3 * random()) } : null,
    counts: { draws: 100, triangles: 254_000, programs: 6, targetBytes: 22e6, uploadBytes: lights * 64 },
    passes: farol ? passesOf(competitor, ms, timer) : null,
    likeness: { reference: 'forward', psnr: competitor === 'forward' ? null : 48 + 10 * random(), thumbnail: '' },
    ...{ dropped: competitor === 'playcanvas' && lights > 900 ? 12 : 0, technique: null, reason: null },
    ...{ problem: null, warnings: random() < 0.01 ? ['The device slowed down by 12% during the case.'] : [] },
  };
  const problem =
    competitor === 'stock' && lights >= 1000
      ? 'The lights take more uniforms than the device has.'
      : ms > (software ? 20_000 : 2000) || (competitor === 'multipass' && lights >= 500)
        ? 'A frame would take longer than 2 s.'
        : null;
  if (problem) Object.assign(row, { frame: null, cpu: null, gpu: null, firstMs: null, problem });
  if (problem) Object.assign(row, { added: null, changed: null, counts: null, passes: null, likeness: null });
  return row;
}

function passesOf(competitor: string, ms: number, timer: boolean): LabRow['passes'] {
  const names = /deferred|prepass|inferred/.test(competitor)
    ? ['lists of lights', 'G-buffer', 'lights', 'output']
    : ['lists of lights', 'depth', 'objects', 'output'];
  const shares = [0.08, 0.22, 0.6, 0.08];
  return { kind: timer ? 'gpu' : 'cpu', passes: names.map((name, i) => ({ name, ms: ms * shares[i] })) };
}

function spreadOf(ms: number, noise: number, random: () => number): Spread {
  const median = ms * (1 + noise * (random() - 0.5));
  return { median, low: median * (1 - noise * random()), high: median * (1 + noise * 2 * random()), samples: 24 };
}
