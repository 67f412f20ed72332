import type { FullscreenPass } from '../gpu/FullscreenPass';
import { lightUniforms, type LightTable } from '../trace/lightTable';
import type { SkySource } from '../trace/SkySource';
import direct from './direct.glsl?raw';
import gather from './gather.glsl?raw';
import type { Grid } from './grid';

/** One reflection of light: it is gathered at all texels before it is reflected again. */
export interface Gather {
  readonly stages: readonly Stage[];
  /** Whether a later gather reflects the gathered light again. */
  readonly isReflected: boolean;
  /** Part of the gathered light that light probes get once reflected: all, that of sky and emissive surfaces, none. */
  readonly probes: 'all' | 'sources' | 'none';
}

/** One kind of light, gathered at every texel. */
export interface Stage {
  readonly pass: FullscreenPass;
  readonly grid: Grid;
  readonly samples: number;
  readonly perDraw: number;
  /** Samples after which a converged texel stops; 0: all texels take all samples. */
  readonly firstSamples: number;
  /** Cost of the whole stage, relative to one sample at each texel of the lightmap. */
  readonly cost: number;
  /** Factor from the mean of the samples to irradiance. */
  readonly scale: number;
  /** Number of the stage's random stream, different for each stage. */
  readonly stream: number;
  /** Whether the light is only reflected, and not written to the lightmap itself. */
  readonly isIndirect: boolean;
  readonly isNoisy: boolean;
  readonly isGather: boolean;
}

/** Numbers from which the stages of a bake are planned. */
export interface StageSource {
  readonly samples: number;
  readonly bounces: number;
  /** Whether any surface is emissive. */
  readonly shines: boolean;
  readonly fine: Grid;
  readonly coarse: Grid;
  /** Returns the trace pass of a name, made on first use. */
  tracePass(
    name: string,
    fragment: string,
    uniforms: Record<string, { value: unknown }>,
    defines: Record<string, unknown>,
  ): FullscreenPass;
}

/** Samples per texel of one draw: constant, so that sums are rounded equally on GPUs of any speed. */
const SAMPLES_OF_A_DRAW = 4;
/** Samples per texel of lights with soft shadows; texels whose first samples are equal stop earlier. */
const softSamples = (samples: number): number =>
  SAMPLES_OF_A_DRAW * Math.ceil(Math.min(samples, Math.max(16, samples / 4)) / 4);
/**
 * Samples of a gather; later gathers hold weaker light, whose noise matters less, and take fewer.
 * @param index - from 0
 */
const gatherSamples = (samples: number, index: number): number =>
  SAMPLES_OF_A_DRAW * Math.ceil(Math.min(samples, Math.max(16, samples / 2 ** index)) / SAMPLES_OF_A_DRAW);

/** Stages of direct light: from lights that are baked whole, then from lights whose reflected light alone is baked. */
export function directStages(source: StageSource, tables: readonly [LightTable, LightTable]): Stage[] {
  const { samples, bounces, fine } = source;
  return tables.flatMap((table, i) => {
    if (i === 1 && bounces === 0) return [];
    const stage = (isSoft: boolean): Stage => {
      const perDraw = isSoft ? SAMPLES_OF_A_DRAW : 1;
      const count = isSoft ? softSamples(samples) : 1;
      const defines = { SAMPLES: perDraw, SOFT: String(isSoft) };
      return {
        pass: source.tracePass(`direct${i}${isSoft ? 'soft' : ''}`, direct, lightUniforms(table), defines),
        ...{ grid: fine, samples: count, perDraw, scale: 1, stream: i + (isSoft ? 2 : 0), isIndirect: i === 1 },
        // with soft shadows, few texels need all samples
        cost: isSoft ? perDraw + 0.1 * count : 1,
        firstSamples: isSoft && count > perDraw ? perDraw : 0,
        isNoisy: isSoft,
        isGather: false,
      };
    };
    return [...(table.hasHard ? [stage(false)] : []), ...(table.hasSoft ? [stage(true)] : [])];
  });
}

/**
 * Gathers after the direct light. Light of lights is reflected `bounces` times. Light of sky and emissive surfaces
 * enters with the first gather, so its last reflection takes one gather more.
 */
export function gathersOf(source: StageSource, skies: readonly [SkySource, SkySource]): Gather[] {
  const { bounces } = source;
  const [sky, hidden] = skies;
  const shines = !sky.isBlack || source.shines;
  const reflectsHidden = !hidden.isBlack && bounces > 0;
  const hasSources = shines || reflectsHidden;
  const count = hasSources ? bounces + 1 : bounces;
  return Array.from({ length: count }, (_, i): Gather => {
    const isLast = hasSources && i === bounces;
    const reflected = {
      ...(i > 0 || bounces > 0 ? { REFLECTED: '' } : {}),
      ...(isLast ? { SOURCES_ALONE: '' } : {}),
    };
    const stages: Stage[] = [];
    if (i === 0 && shines) {
      const defines = { ...sky.defines, ...reflected, FROM_SOURCES: '' };
      stages.push(gatherStage(source, 'sources', i, false, sky.uniforms, defines, 8));
    } else if (i > 0 || bounces > 0) {
      stages.push(gatherStage(source, isLast ? 'last' : 'bounce', i, false, {}, reflected, 16 + i));
    }
    if (i === 0 && reflectsHidden) {
      stages.push(gatherStage(source, 'hidden', i, true, hidden.uniforms, { ...hidden.defines, FROM_SOURCES: '' }, 9));
    }
    const probes = i <= bounces - 2 ? 'all' : hasSources && i === bounces - 1 ? 'sources' : 'none';
    return { stages, isReflected: i < count - 1, probes };
  });
}

function gatherStage(
  source: StageSource,
  name: string,
  index: number,
  isIndirect: boolean,
  uniforms: Record<string, { value: unknown }>,
  defines: Record<string, unknown>,
  stream: number,
): Stage {
  const samples = gatherSamples(source.samples, index);
  const noSky = { SKY_LIGHTS: 1, SAMPLES: SAMPLES_OF_A_DRAW };
  const pass = source.tracePass(name, gather, uniforms, { ...noSky, ...defines });
  const grid = index === 0 ? source.fine : source.coarse;
  const cost = samples * (grid.size / source.fine.size) ** 2;
  const base = { perDraw: SAMPLES_OF_A_DRAW, cost, scale: Math.PI, stream, isIndirect };
  return { pass, samples, grid, firstSamples: 0, isNoisy: true, isGather: true, ...base };
}
