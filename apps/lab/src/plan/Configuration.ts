import type { Axis, Effort } from './LabPlan';
import type { LightKind, Shading } from './lightKinds';

/** Settings of a series: cases that differ along one axis. */
export interface SeriesChoice {
  /** Key in `sceneWords`. */
  readonly scene: string;
  /** Number of planes along a side of their square grid, in the scene of planes; unused by other scenes. */
  readonly n: number;
  readonly axis: Axis;
  /**
   * Ascending numbers of lights, objects, thousands of pixels, layers of overdraw or shadowed lights, by the axis; for kinds
   * of lights and shadings indices into `lightKindNames` and `shadingNames`.
   */
  readonly values: readonly number[];
  /** Number of moving lights, unless it is the axis; `objects` for as many as there are planes. */
  readonly lights: number | 'objects';
  /** Kind of the moving lights, unless it is the axis. Default points. */
  readonly lightKind?: LightKind;
  /** Range of each moving light (m), 0.1 to 100. Default, or null: the scene's own range for this number of lights. */
  readonly lightRange?: number | null;
  /** Shading of the materials, unless it is the axis. Default their own shading. */
  readonly shading?: Shading;
}

/** Settings of a run, edited by the builder and stored in the address. */
export interface Configuration {
  /** Key in `presets`, or `custom`. */
  readonly preset: string;
  readonly series: readonly SeriesChoice[];
  /** Size of the picture (pixels); along an axis of pixels only its aspect ratio is used. */
  readonly width: number;
  readonly height: number;
  /** Keys in `competitorNames`. */
  readonly competitors: readonly string[];
  readonly effort: Effort;
}
