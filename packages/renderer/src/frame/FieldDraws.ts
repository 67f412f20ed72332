import type { Texture } from 'three';
import type { ForwardTwins } from '../materials/forwardTwin';
import type { Frame } from './Frame';
import type { LightLists } from './LightLists';
import type { TileDepthUse } from '../lighting/lists/TileDepthUse';
import type { LightLoop } from '../materials/LightLoop';

/**
 * Lights of fields as passes use them; light-fields/LightFields.ts, whose code is fetched on demand, has the class. Methods take
 * the frame that the pass was given: a warm-up has one of its own.
 */
export interface FieldDraws {
  /** The light table that shaders read, once `render` has drawn it. */
  readonly texture: Texture;
  /** Number of lights in all light fields of the frame. */
  readonly count: number;
  /** Mean number of field lights over a pixel, whatever their depth; an estimate. */
  readonly coverage: number;
  readonly bytes: number;
  /** Whether the fields' lights have been drawn in this frame. */
  readonly isDrawn: boolean;
  /** Draws the light table. Call inside three's `render` before anything lit is drawn; restores the bound target. */
  render(): void;
  /** Makes the lists of the fields' lights that reach each tile of the screen. */
  makeTiles(frame: Frame, use: TileDepthUse): void;
  /** Makes lists of the lights of fields alone that reach each tile, whatever their depth. */
  makeFieldTiles(frame: Frame): void;
  /** Makes the lists of the fields' lights that reach each cluster. */
  makeClusters(frame: Frame): LightLists;
  /** Twins that light items by fields too, in place of the loop's own twins; undefined where those do. */
  twinsFor(loop: LightLoop): ((view: string) => ForwardTwins) | undefined;
}
