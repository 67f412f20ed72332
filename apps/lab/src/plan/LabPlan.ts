import type { LightKind, Shading } from './lightKinds';

/** Scene of a case: one of `scenes` of `@farol/scenes`, or `own`, the scene that another app handed over. */
export interface SceneChoice {
  /** Key in `scenes`, or `own`. */
  readonly name: string;
  /** Values of the scene's parameters; the number of lights stands in the case. */
  readonly parameters: Readonly<Record<string, number | string | boolean>>;
}

/** One picture to be drawn by every competitor. */
export interface LabCase {
  readonly scene: SceneChoice;
  /** Moving lights; null where the scene fixes them (`own`). */
  readonly lights: number | null;
  /** Of them, how many cast shadows (maps of 512 texels a side). */
  readonly shadows: number;
  /** What the moving lights are. */
  readonly lightKind: LightKind;
  /** How far each of them reaches (m); null for what the scene gives so many lights. */
  readonly lightRange: number | null;
  readonly shading: Shading;
  /** Layers of quads that cover the picture one behind the other; 0 for the scene as it is. */
  readonly overdraw: number;
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
}

/** Fields of a case as they are in runs and callers that do not know them yet. */
export const plainCase = { lightKind: 'points', lightRange: null, shading: 'own' } as const satisfies Partial<LabCase>;

/** What the curves of a run have along their x axis. */
export type Axis = 'lights' | 'objects' | 'pixels' | 'overdraw' | 'shadows' | 'kind' | 'shading';

/** Whether the values of an axis are places in a list of names: `lightKindNames`, `shadingNames`. */
export const isNamed = (axis: Axis): axis is 'kind' | 'shading' => axis === 'kind' || axis === 'shading';

/** A chart of its own: cases that differ along one axis, in ascending order of it. */
export interface LabSeries {
  /** Unique within the plan, lower-kebab: `sponza`, `planes`. */
  readonly name: string;
  readonly label: string;
  readonly axis: Axis;
  readonly cases: readonly LabCase[];
  /** Value of each case along the axis. */
  readonly values: readonly number[];
}

/** How long and how often each competitor is measured in each case. */
export interface Effort {
  /** Turns that each competitor gets, A B C A B C. */
  readonly rounds: number;
  /** Length of a turn (ms), shared among throughput, CPU and GPU times. */
  readonly turn: number;
  /**
   * Measure first frames, the frame after ten lights more, and the frame after the technique changed; where the run has a
   * `limit`, in the first case of each series alone.
   */
  readonly changes: boolean;
  /** A competitor is left out, and says so, where its first frame or an ordinary one would take longer than this (ms). */
  readonly longestFrame: number;
  /** Time for the whole run (ms): turns become shorter so that it ends by then. Null for none. */
  readonly limit: number | null;
}

/** What a run measures: series of cases, each by every competitor. */
export interface LabPlan {
  /** Key in `presets`, or `custom`. */
  readonly preset: string;
  readonly label: string;
  readonly series: readonly LabSeries[];
  /** Keys of competitors (`competitorNames`), in the order in which they take turns. */
  readonly competitors: readonly string[];
  readonly effort: Effort;
}
