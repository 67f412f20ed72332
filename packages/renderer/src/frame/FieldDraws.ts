import type { Texture } from 'three';
import type { ForwardTwins } from '../materials/forwardTwin';
import type { View } from './views';
import type { LightLists } from './LightLists';
import type { TileDepthUse } from '../lighting/lists/TileDepthUse';
import type { LightLoop } from '../materials/LightLoop';

/**
 * Draws of light fields that passes call; implemented by late code, light-fields/LightFields.ts. `F` is `Frame`: each
 * call names its frame, since a warm-up has one of its own.
 */
export interface FieldDraws<F> {
  /** The light table that shaders read, once `render` has drawn it. */
  readonly texture: Texture;
  /** Number of lights in all fields of the frame. */
  readonly count: number;
  /** Mean number of field lights over a pixel, whatever their depth; an estimate. */
  readonly coverage: number;
  readonly bytes: number;
  /** Whether `render` has drawn in this frame. */
  readonly isDrawn: boolean;
  /** Draws the light table. Call inside three's `render` before anything lit is drawn; restores the bound target. */
  render(): void;
  /** Makes lists of all lights that reach each tile. */
  makeTiles(frame: F, use: TileDepthUse): void;
  /** Makes lists of the lights of fields alone that reach each tile, whatever their depth. */
  makeFieldTiles(frame: F): void;
  /** Makes lists of all lights that reach each cluster. */
  makeClusters(frame: F): LightLists;
  /** Twins that light items by fields too, to be used in place of the loop's twins; undefined where those do. */
  twinsFor(loop: LightLoop): ((view: View) => ForwardTwins) | undefined;
}
