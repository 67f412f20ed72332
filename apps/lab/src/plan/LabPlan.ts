import type { LightKind, Shading } from './lightKinds';

/** Scene of a case: one of `scenes` of `@farol/scenes`, or `own`, the scene handed over by another app. */
export interface SceneChoice {
  /** Key in `scenes`, or `own`. */
  readonly name: string;
  /** Values of the scene's parameters other than the number of lights, which is in the case. */
  readonly parameters: Readonly<Record<string, number | string | boolean>>;
}

/** One picture that every competitor draws. */
export interface LabCase {
  readonly scene: SceneChoice;
  /** Number of moving lights; null for scene `own`, which has its own. */
  readonly lights: number | null;
  /** Number of moving lights that cast shadows, by maps of 512 texels per side. */
  readonly shadows: number;
  readonly lightKind: LightKind;
  /** Range of the moving lights (m); null for the scene's own range. */
  readonly lightRange: number | null;
  readonly shading: Shading;
  /** Number of quads that cover the whole picture, one behind the other; 0 for none. */
  readonly overdraw: number;
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
}

/** Values of fields that older runs lack. */
export const plainCase = { lightKind: 'points', lightRange: null, shading: 'own' } as const satisfies Partial<LabCase>;

/** Property along the x axis of a run's curves. */
export type Axis = 'lights' | 'objects' | 'pixels' | 'overdraw' | 'shadows' | 'kind' | 'shading';

/** Whether the values of an axis are indices into a list of names: `lightKindNames`, `shadingNames`. */
export const isNamed = (axis: Axis): axis is 'kind' | 'shading' => axis === 'kind' || axis === 'shading';

/** Cases of one chart, ascending along one axis. */
export interface LabSeries {
  /** Unique within the plan, lower-kebab: `sponza`, `planes`. */
  readonly name: string;
  readonly label: string;
  readonly axis: Axis;
  readonly cases: readonly LabCase[];
  /** Value of each case along the axis. */
  readonly values: readonly number[];
}

/** Duration and repetition of the measurements of a competitor in a case. */
export interface Effort {
  /** Number of turns of each competitor, interleaved: A B C A B C. */
  readonly rounds: number;
  /** Length of a turn (ms), shared among throughput, CPU and GPU times. */
  readonly turn: number;
  /**
   * Whether to measure the frames after ten lights were added, and after the technique was changed. A run with a
   * `limit` measures these only in the first case of each series.
   */
  readonly changes: boolean;
  /** Longest first or ordinary frame (ms): a competitor that takes longer is left out, with a problem in its row. */
  readonly longestFrame: number;
  /** Time limit of the whole run (ms), for which turns are shortened; null for none. */
  readonly limit: number | null;
}

/** Series of cases, each to be measured for every competitor. */
export interface LabPlan {
  /** Key in `presets`, or `custom`. */
  readonly preset: string;
  readonly label: string;
  readonly series: readonly LabSeries[];
  /** Keys in `competitorNames`, in the order of turns. */
  readonly competitors: readonly string[];
  readonly effort: Effort;
}
