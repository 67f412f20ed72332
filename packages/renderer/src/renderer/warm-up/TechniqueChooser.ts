import type { Frame } from '../../frame/Frame';
import type { LightTable } from '../../lighting/LightTable';
import { MOST_IN_A_LOOP } from '../TechniqueSet';
import type { Overdraw } from './Overdraw';

/** Cheap figures of a frame, known before anything is drawn. */
export interface SceneFigures {
  /** Number of lights in view that have a range. */
  readonly bounded: number;
  /** Number of lights that reach every pixel: directional ones and those without a range. */
  readonly everywhere: number;
  /** Mean number of lights with a range over a pixel, at any depth. */
  readonly coverage: number;
  /** Number of opaque items drawn. */
  readonly objects: number;
  /** Whether lit transmissive or transparent items were drawn: tile lists made on the GPU do not cover them. */
  readonly transparents: boolean;
  /** Whether float colour targets can be drawn to. */
  readonly floatTargets: boolean;
  /** Whether an effect works on a G-buffer. */
  readonly surfaces: boolean;
  /** Number of pixels of the picture. */
  readonly pixels: number;
  /** Whether the host's target has several samples a pixel: a depth pre-pass is then drawn twice. */
  readonly multisampled: boolean;
  /** Estimated shadings of a pixel that later items hide, on average; 0 until estimated. */
  readonly overdraw: number;
  /** Number of triangles that a depth pre-pass would draw; 0 until it is estimated. */
  readonly triangles: number;
}

/** Techniques that the chooser picks from. */
export type ChosenTechnique =
  | 'forward-single-pass'
  | 'clustered-forward'
  | 'forward-plus'
  | 'clustered-deferred'
  | 'tiled-deferred';

/** Compiles a technique's programs ahead, over some frames. */
export interface Preparation {
  readonly ready: boolean;
}

export interface Choice {
  readonly technique: ChosenTechnique;
  readonly reason: string;
}

/** Up to this many lights, light lists cost more than they save. All bounds here are measured: see docs/performance.md. */
const FEW_LIGHTS = 2;
/** FEW_LIGHTS for a scene in which a pixel is drawn about once. */
const FEW_LIGHTS_OVER_FEW_OBJECTS = 4;
/** Up to this many opaque items, each pixel is shaded about once. */
const FEW_OBJECTS = 8;
/** Mean number of lights over a pixel from which on a G-buffer pays. */
const MANY_OVER_A_PIXEL = 3;
/** Number of small lights with a range from which on tile lists, made on the GPU, cost less than cluster lists. */
const MANY_LIGHTS = 90;
/**
 * Greatest share of the picture that a small light covers. Larger lights fill whole tiles; only clusters separate their
 * depths.
 */
const SMALL_LIGHT = 0.125;
/**
 * Number of lights with a range, of any size, from which on clusters, which the CPU sorts lights into, cost more than they
 * save.
 */
const VERY_MANY_LIGHTS = 200;
/**
 * Number of opaque items from which on the CPU takes longer than the GPU, and number of lights from which on tile lists, which
 * the GPU makes, then save CPU time.
 */
const MANY_OBJECTS = 1000;
const MANY_LIGHTS_OVER_MANY_OBJECTS = 50;
/**
 * Costs of 'forward-plus', whose depth pre-pass leaves one shading of each pixel, in shadings of a pixel (0.5 ns on an H200):
 * depth, its copy and tile lists, compared with a G-buffer and its output, and with a forward technique; each light over a
 * pixel, since materials loop over the list; a triangle drawn twice; the passes themselves, for any picture.
 */
const DEPTH_BESIDE_GBUFFER = 0.2;
const DEPTH_BESIDE_FORWARD = 0.7;
const LIGHT_BY_MATERIALS = 0.02;
const TRIANGLE_TWICE = 4.2;
const PASSES = 300_000;
/** Factor by which a bound must be passed, for some frames in a row, before another technique is chosen. */
const SLACK = 1.3;
const PATIENCE = 8;
/** Number of frames in a row in which another technique is best, even slightly, after which the choice changes. */
const LASTING = 120;
/**
 * Factor by which a bound must be passed to change the choice at once in a scene's first frames: the scene is loading, and may
 * not be drawn again soon.
 */
const FAR = 4;

const choices: Record<ChosenTechnique, Choice> = {
  'forward-single-pass': {
    technique: 'forward-single-pass',
    reason: 'few lights: lists cost more than they save',
  },
  'clustered-forward': {
    technique: 'clustered-forward',
    reason: 'few lights over a pixel: a G-buffer costs more than it saves',
  },
  'forward-plus': {
    technique: 'forward-plus',
    reason: 'surfaces hide one another: depth is drawn first, so that each pixel is shaded once',
  },
  'clustered-deferred': {
    technique: 'clustered-deferred',
    reason: 'many lights over a pixel: each surface is lit once, by the list of its cluster',
  },
  'tiled-deferred': {
    technique: 'tiled-deferred',
    reason: 'very many lights over a pixel: each surface is lit once, by the list of its tile',
  },
};

/**
 * Picks a technique for the frames of a scene from cheap figures, and keeps to it unless another has been better for some
 * frames, or is far better while the scene is new. Without allocation.
 */
export class TechniqueChooser<P extends Preparation = Preparation> {
  /** Technique to draw by as soon as its programs are ready; null when the present one is to stay. */
  next: Choice | null = null;
  /** Compiles `next`. Set by the caller; dropped when `next` changes. */
  preparation: P | null = null;
  private current: Choice | null = null;
  private waited = 0;
  /** Number of frames in a row in which another technique than `current` was best. */
  private outdone = 0;
  private frames = 0;

  /** Whether the scene was drawn often enough to be on the screen, no longer loading. */
  get settled(): boolean {
    return this.frames > PATIENCE;
  }

  /** Whether another technique has been better lately, so that the choice may change within the next frames. */
  get isChanging(): boolean {
    return this.waited > 0;
  }

  choose(figures: SceneFigures): Choice {
    const best = choices[this.best(figures, 1)];
    const { current } = this;
    if (current === null) return (this.current = best);
    if (!this.settled) this.frames++;
    this.outdone = best === current ? 0 : this.outdone + 1;
    const holds = best === current || (this.outdone < LASTING && this.holds(figures, SLACK));
    this.waited = holds ? 0 : this.waited + 1;
    const deferred = current.technique.endsWith('deferred');
    const isTooMany =
      current.technique === 'forward-single-pass' && figures.bounded + figures.everywhere > MOST_IN_A_LOOP;
    const impossible = deferred ? !figures.floatTargets : isTooMany || (figures.surfaces && figures.floatTargets);
    const next = this.waited >= PATIENCE ? best : null;
    if (next !== this.next) this.preparation = null;
    this.next = next;
    if (
      impossible ||
      (next !== null && this.preparation?.ready) ||
      !(this.settled || holds || this.holds(figures, FAR))
    ) {
      this.current = best;
      this.next = this.preparation = null;
      this.waited = 0;
    }
    return this.current!;
  }

  /** Whether the current choice stays best with its bounds widened by the factor `slack`. */
  private holds(figures: SceneFigures, slack: number): boolean {
    const { technique } = this.current!;
    return this.best(figures, slack) === technique || this.best(figures, 1 / slack) === technique;
  }

  /**
   * Technique that the rule picks for figures.
   * @param scale - factor of its bounds: above 1, more lights a pixel are needed for a G-buffer, and lists and overdraw count
   *   for less
   */
  best(figures: SceneFigures, scale: number): ChosenTechnique {
    const listed = this.withoutDepth(figures, scale);
    const { pixels, coverage, everywhere, overdraw, triangles, transparents, surfaces, multisampled } = figures;
    if (transparents || surfaces || multisampled) return listed;
    const depth = listed.endsWith('deferred') ? DEPTH_BESIDE_GBUFFER : DEPTH_BESIDE_FORWARD;
    const saved = pixels * (overdraw - depth - (coverage + everywhere) * LIGHT_BY_MATERIALS);
    return saved * scale > PASSES + triangles * TRIANGLE_TWICE ? 'forward-plus' : listed;
  }

  /** Best technique of those without a depth pre-pass. */
  private withoutDepth(
    { bounded, everywhere, coverage, objects, transparents, floatTargets, surfaces }: SceneFigures,
    scale: number,
  ): ChosenTechnique {
    if (!surfaces || !floatTargets) {
      const few = objects <= FEW_OBJECTS ? FEW_LIGHTS_OVER_FEW_OBJECTS : FEW_LIGHTS;
      if (bounded + everywhere <= few * scale) return 'forward-single-pass';
      if (!floatTargets || (coverage + everywhere) * scale <= MANY_OVER_A_PIXEL) return 'clustered-forward';
    }
    const many = bounded * scale;
    const small = coverage <= SMALL_LIGHT * many;
    const ofAnyObjects = small ? MANY_LIGHTS : VERY_MANY_LIGHTS;
    const bound = objects * scale > MANY_OBJECTS ? MANY_LIGHTS_OVER_MANY_OBJECTS : ofAnyObjects;
    return many > bound && !transparents ? 'tiled-deferred' : 'clustered-deferred';
  }
}

/**
 * Figures of a frame whose lights are collected.
 * @param surfaces - whether an effect works on a G-buffer
 * @param floatTargets - whether float colour targets can be drawn to
 */
export function figuresOf(
  frame: Frame,
  { bounded, coverage, directional, unbounded }: LightTable,
  overdraw: Overdraw | null,
  surfaces: boolean,
  floatTargets: boolean,
): SceneFigures {
  return {
    bounded: bounded + (frame.fields?.count ?? 0),
    coverage: coverage + (frame.fields?.coverage ?? 0),
    everywhere: directional + unbounded,
    objects: frame.queue.opaque.length,
    transparents: frame.queue.hasLitTransparents,
    floatTargets,
    surfaces,
    pixels: frame.width * frame.height,
    multisampled: frame.hostSamples > 0,
    overdraw: overdraw?.layers ?? 0,
    triangles: overdraw?.triangles ?? 0,
  };
}
