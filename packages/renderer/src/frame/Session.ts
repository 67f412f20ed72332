import type { Light } from 'three';
import type { ActiveEffects } from './ActiveEffects';
import type { RecordSettings } from '../lighting/LightRecords';
import type { LightTable } from '../lighting/LightTable';
import type { PlainPoints } from '../lights/plainPoints';
import type { Frame } from './Frame';
import type { TwinAdapter } from './TwinAdapter';

/**
 * An XR session as a frame sees it: lights are found and shadow maps drawn with the first eye, for all of them. Draws of a picture's
 * parts are one too (`@farol/renderer/pixel-lighting`), whose first eye is the whole picture.
 */
export interface Session {
  /** Index of the eye that is drawn, in the order in which they are drawn. */
  eye: number;
  /** Adapters of twins that draw both eyes at once, of which WebGL has no timers; null while each eye is drawn by itself. */
  readonly adapters: readonly TwinAdapter[] | null;
  /** Bytes of targets of the session's own. */
  readonly bytes: number;
  /** Whether a frame of both eyes must be drawn eye by eye instead. Called when all that it draws is known. */
  refuses(frame: Frame, technique: string, effects: number): boolean;
  dispose(): void;
  /** Ends a frame of both eyes, inside three's `render`. */
  present(frame: Frame): void;
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
