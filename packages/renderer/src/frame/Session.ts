import type { Light } from 'three';
import type { ActiveEffects } from './ActiveEffects';
import type { RecordSettings } from '../lighting/LightRecords';
import type { LightTable } from '../lighting/LightTable';
import type { PlainPoints } from '../lights/plainPoints';
import type { Frame } from './Frame';
import type { TwinAdapter } from './TwinAdapter';

/**
 * An XR session as a frame sees it: with the first eye, lights are found and shadow maps drawn for all eyes.
 * `@farol/renderer/pixel-lighting`, which draws parts of a picture, is a session too; its first eye is the whole picture.
 */
export interface Session {
  /** Index of the eye that is drawn, in drawing order. */
  eye: number;
  /** Adapters of twins that draw both eyes at once, which timer queries cannot measure; null while each eye is drawn separately. */
  readonly adapters: readonly TwinAdapter[] | null;
  /** Bytes of the session's own targets. */
  readonly bytes: number;
  /** Whether a frame of both eyes must be drawn eye by eye instead. Called when the queue is complete. */
  refuses(frame: Frame, technique: string, effects: number): boolean;
  dispose(): void;
  /** Ends a frame of both eyes, inside three's `render`. */
  present(frame: Frame): void;
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
