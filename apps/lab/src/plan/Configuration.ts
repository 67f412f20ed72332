import type { Axis, Effort } from './LabPlan';
import type { LightKind, Shading } from './lightKinds';

/** Cases that differ along one axis, as a user chooses them. */
export interface SeriesChoice {
  /** Key in `sceneWords`. */
  readonly scene: string;
  /** Objects along a side of the planes; unused by other scenes. */
  readonly n: number;
  readonly axis: Axis;
  /**
   * Ascending: lights, objects, thousands of pixels, layers of overdraw or shadowed lights, as the axis says; for kinds of
   * lights and shadings their places in `lightKindNames` and `shadingNames`.
   */
  readonly values: readonly number[];
  /** Moving lights where the axis is another; `objects` for as many as there are planes. */
  readonly lights: number | 'objects';
  /** What they are, where the axis is another. Default points. */
  readonly lightKind?: LightKind;
  /** How far each reaches (m), 0.1 to 100. Default, or null: what the scene gives so many lights. */
  readonly lightRange?: number | null;
  /** How materials are shaded, where the axis is another. Default their own. */
  readonly shading?: Shading;
}

/** What a run is to measure, as the builder and the address hold it. */
export interface Configuration {
  /** Key in `presets`, or `custom`. */
  readonly preset: string;
  readonly series: readonly SeriesChoice[];
  /** Size of the picture (pixels); its sides' ratio stays where the axis is pixels. */
  readonly width: number;
  readonly height: number;
  /** Keys in `competitorNames`. */
  readonly competitors: readonly string[];
  readonly effort: Effort;
}
