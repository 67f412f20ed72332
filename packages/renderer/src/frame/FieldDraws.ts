import type { Texture } from 'three';
import type { ForwardTwins } from '../materials/forwardTwin';
import type { Frame } from './Frame';
import type { LightLists } from './LightLists';
import type { TileDepthUse } from '../lighting/lists/TileDepthUse';
import type { LightLoop } from '../materials/LightLoop';

/**
 * Lights of light fields, as passes use them; implemented by light-fields/LightFields.ts, which is late code. Methods take the
 * pass's frame, since a warm-up has its own.
 */
export interface FieldDraws {
  /** The light table that shaders read; valid after `render`. */
  readonly texture: Texture;
  /** Number of lights in all light fields of the frame. */
  readonly count: number;
  /** Estimated mean number of field lights over a pixel, at any depth. */
  readonly coverage: number;
  readonly bytes: number;
  /** Whether `render` has drawn the fields' lights into the light table in this frame. */
  readonly isDrawn: boolean;
  /** Draws the light table. Call inside three's `render` before any lit draw; restores the bound target. */
  render(): void;
  /** Draws the lists of all lights that reach each tile of the screen. */
  makeTiles(frame: Frame, use: TileDepthUse): void;
  /** Draws lists of only the fields' lights that reach each tile, at any depth. */
  makeFieldTiles(frame: Frame): void;
  /** Draws the lists of all lights that reach each cluster. */
  makeClusters(frame: Frame): LightLists;
  /** Twins that replace a light loop's own and also read fields; undefined if the loop's own twins read fields. */
  twinsFor(loop: LightLoop): ((view: string) => ForwardTwins) | undefined;
}
