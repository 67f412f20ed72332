import type { LightOrder } from '../lights/LightTable';
import type { GridUniforms } from '../passes/LightGridPass';
import type { TileUniforms } from '../passes/LightTilesPass';
import type { Pass } from '../passes/Pass';

/** What a technique's passes are made with. */
export interface TechniqueContext {
  /** Uniform of the record that a single-light pass draws. */
  readonly lightIndex: { value: number };
  /** Where the light lists of tiles are. */
  readonly tiles: TileUniforms;
  /** Where the light grid is. */
  readonly grid: GridUniforms;
  /** Texels of the buffers of 'inferred' a pixel, along a side: above 0, at most 1. May change from frame to frame. */
  readonly inferredScale: { readonly value: number };
}

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
  /** True if it writes every pixel of the target, background too, and so needs no clear of the target's. Default false. */
  readonly fillsTarget?: boolean;
  passes(context: TechniqueContext): Pass[];
}
