import type { Light } from 'three';
import type { RecordSettings } from '../lighting/LightRecords';
import type { LightTable } from '../lighting/LightTable';
import type { PlainPoints } from '../lights/plainPoints';

/** An XR session as a frame sees it: lights are found and shadow maps drawn with the first eye, for all of them. */
export interface Session {
  /** Index of the eye that is drawn, in the order in which they are drawn. */
  eye: number;
  /**
   * Lights that may have a mask and that any eye sees. Leaves the table as collected for the first eye.
   * @param points - what the lights give, as `LightTable.collect` takes them
   */
  masked(
    table: LightTable,
    lights: readonly Light[],
    settings: RecordSettings,
    points: PlainPoints | null,
  ): readonly Light[];
}
