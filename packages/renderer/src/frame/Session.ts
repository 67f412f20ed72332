import type { Light } from 'three';
import type { ActiveEffects } from './ActiveEffects';
import type { RecordSettings } from '../lighting/LightRecords';
import type { LightTable } from '../lighting/LightTable';
import type { PlainPoints } from '../lights/plainPoints';
import type { Frame } from './Frame';

/**
 * An XR session as a frame sees it: with the first eye, lights are found and shadow maps drawn for all eyes.
 * `@farol/renderer/pixel-lighting`, which draws parts of a picture, is a session too; its first eye is the whole picture.
 */
export interface Session {
  /** Index of the eye that is drawn, in drawing order. */
  eye: number;
  /**
   * Lights that may have a mask and that any eye sees. Leaves the table as collected for the first eye.
   * @param points - values of plain point lights, as for `LightTable.collect`
   */
  masked(
    table: LightTable,
    lights: readonly Light[],
    settings: RecordSettings,
    points: PlainPoints | null,
  ): readonly Light[];
  /** Effects in place of the host's. Default: those of the host's that work in sessions. */
  readonly effects?: ActiveEffects;
  /** Lights of the eye, selected from the scene's managed lights, which must not be changed. Default all. */
  lightsOf?(found: readonly Light[]): readonly Light[];
  /** Called after the light table is written, before it is uploaded. */
  written?(frame: Frame): void;
}
