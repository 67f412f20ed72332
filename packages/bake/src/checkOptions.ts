import type { BakeOptions, TraceOptions } from './BakeOptions';

type Checked<T, Kept extends keyof T> = Required<Omit<T, Kept>> & Pick<T, Kept>;

/** Options with defaults filled in. */
export type CheckedTraceOptions = Checked<TraceOptions, 'signal' | 'onProgress'>;
export type CheckedBakeOptions = CheckedTraceOptions &
  Checked<Omit<BakeOptions, keyof TraceOptions>, 'texelsPerMetre' | 'probes'>;

/** @throws RangeError that names the option, its bounds and its value */
export function checkTraceOptions(options: TraceOptions): CheckedTraceOptions {
  return {
    bounces: whole('bounces', options.bounces ?? 3, 0, 16),
    samples: whole('samples', options.samples ?? 256, 1, 65536),
    indirectScale: scale(options.indirectScale ?? 0.5),
    sky: options.sky ?? 'none',
    seed: whole('seed', options.seed ?? 1, 0, 0xffffffff),
    sliceMilliseconds: within('sliceMilliseconds', options.sliceMilliseconds ?? 12, 1, 1000),
    isStatic: options.isStatic ?? (() => true),
    isBaked: options.isBaked ?? (() => true),
    throwsShadow: options.throwsShadow ?? (() => true),
    onWarning: options.onWarning ?? ((sentence) => console.warn(`@farol/bake: ${sentence}`)),
    signal: options.signal,
    onProgress: options.onProgress,
  };
}

/** @throws RangeError that names the option, its bounds and its value */
export function checkBakeOptions(options: BakeOptions): CheckedBakeOptions {
  const size = whole('size', options.size ?? 1024, 16, 8192);
  if (size % 16 !== 0) throw new RangeError(`size must be a multiple of 16, and is ${size}.`);
  const { texelsPerMetre, probes } = options;
  if (probes && (probes.length % 3 !== 0 || !probes.every(Number.isFinite))) {
    throw new RangeError('probes must be three numbers for each point.');
  }
  if (texelsPerMetre !== undefined) within('texelsPerMetre', texelsPerMetre, 1e-3, 1e5);
  return {
    ...checkTraceOptions(options),
    ...{ size, texelsPerMetre, probes: options.probes },
    padding: whole('padding', options.padding ?? 4, 1, 16),
    denoise: options.denoise ?? true,
    stitch: options.stitch ?? true,
    showProgress: options.showProgress ?? true,
  };
}

function scale(value: number): 1 | 0.5 | 0.25 {
  if (value === 1 || value === 0.5 || value === 0.25) return value;
  throw new RangeError(`indirectScale must be 1, 0.5 or 0.25, and is ${value}.`);
}

function within(name: string, value: number, least: number, most: number): number {
  if (value >= least && value <= most) return value;
  throw new RangeError(`${name} must be ${least} to ${most}, and is ${value}.`);
}

function whole(name: string, value: number, least: number, most: number): number {
  if (Number.isInteger(within(name, value, least, most))) return value;
  throw new RangeError(`${name} must be a whole number, and is ${value}.`);
}
