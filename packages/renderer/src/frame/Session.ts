import type { Light } from 'three';
import type { ActiveEffects } from './ActiveEffects';
import type { RecordSettings } from '../lighting/LightRecords';
import type { LightTable } from '../lighting/LightTable';
import type { PlainPoints } from '../lights/plainPoints';
import type { Frame } from './Frame';

/**
 * An XR session as a frame sees it: lights are found and shadow maps drawn with the first eye, for all of them. Draws of a picture's
 * parts are one too (`@farol/renderer/pixel-lighting`), whose first eye is the whole picture.
 */
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
  /** Effects that draw in place of the host's. Default: the host's that a session can have. */
  readonly effects?: ActiveEffects;
  /** Lights that light the eye, from the managed ones of the scene, which are not to be changed. Default all. */
  lightsOf?(found: readonly Light[]): readonly Light[];
  /** Called when the light table is written, before it is uploaded. */
  written?(frame: Frame): void;
}
