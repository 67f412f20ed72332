import type { LateCode } from '../frame/lazyCode';
import type { LightOrder } from '../lighting/LightTable';
import type { MicroShaderRegistry } from '../microshaders';
import type { GridUniforms } from '../lighting/lists/gridUniforms';
import type { TileUniforms } from '../lighting/lists/tileUniforms';
import type { Pass } from '../frame/Pass';

/** What a technique's passes are made with. */
export interface TechniqueContext {
  /** Where microshaders of its own are added. */
  readonly microshaders: MicroShaderRegistry;
  /** Uniform of the record that a single-light pass draws. */
  readonly lightIndex: { value: number };
  /** Where the light lists of tiles are. */
  readonly tiles: TileUniforms;
  /** Where the light grid is. */
  readonly grid: GridUniforms;
  /** Texels of the buffers of 'inferred' a pixel, along a side: above 0, at most 1. May change from frame to frame. */
  readonly inferredScale: { readonly value: number };
}

/**
 * How a technique spares three a clear of the target, which costs as much as a draw over all pixels: 'every-pixel' writes
 * colour and depth of every pixel, so that neither need be cleared; 'behind' writes the background's colour behind the
 * opaque items once they are drawn, so that colour need not be.
 */
export type Fills = 'every-pixel' | 'behind';

/** A way of drawing: an array of passes. */
export interface Technique {
  /** Name in menus. */
  readonly label: string;
  /** One line of help. */
  readonly help: string;
  /** How its passes want the lights in the table. */
  readonly lightOrder: LightOrder;
  /** True if it draws to float colour targets. */
  readonly needsFloatTargets: boolean;
  /** Its part in clearing the target: what it writes where nothing is. Default 'behind'. */
  readonly fills?: Fills;
  /** Code that it needs and that is fetched when it is first drawn by; 'deferred' draws until it is there. Default none. */
  readonly late?: LateCode<unknown>;
  passes(context: TechniqueContext): Pass[];
}
