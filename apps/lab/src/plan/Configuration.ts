import type { Axis, Effort } from './LabPlan';

/** Cases that differ along one axis, as a user chooses them. */
export interface SeriesChoice {
  /** Key in `sceneWords`. */
  readonly scene: string;
  /** Objects along a side of the planes; unused by other scenes. */
  readonly n: number;
  readonly axis: Axis;
  /** Ascending: lights, objects, thousands of pixels, layers of overdraw or shadowed lights, as the axis says. */
  readonly values: readonly number[];
  /** Point lights where the axis is another; `objects` for as many as there are planes. */
  readonly lights: number | 'objects';
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
