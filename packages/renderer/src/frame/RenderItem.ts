import type { RenderListItem } from '../three/RenderListItem';

/**
 * Shading of an item: 'lit' by Farol's lights, one at a time; 'shadow-mask' by three's `getShadowMask()`, which shows
 * Farol's shadows; 'nodes' by three itself, since its material is of nodes (TSL); 'unlit' by its material as it is.
 */
export type ItemShading = 'lit' | 'unlit' | 'shadow-mask' | 'nodes';

/**
 * Which passes may draw an item, and when. 'split': opaque and lit by three's own shader as it is, so that passes may share
 * its shading out, in an order of their own. 'plain': opaque, drawn whole by any pass in an order of its own. 'ordered':
 * opaque, in three's order, since its picture, or that of what comes after it, depends on the order. 'forward': by the
 * forward pass: all that transmits or is transparent, and what is opaque otherwise than three's default.
 */
export type ItemRoute = 'split' | 'plain' | 'ordered' | 'forward';

/** One draw as three's traversal gives it, of the host's material (or the scene's override). Pooled: valid for the frame only. */
export interface RenderItem extends RenderListItem {
  /** Place of the material among opaque items, see `RenderQueue.ranks`. */
  rank: number;
  shading: ItemShading;
  route: ItemRoute;
  /** Whether the material's shader is changed, by the host or a surface. */
  ownShader: boolean;
  /** Other lights may reach it than most things, so that it is drawn forward. */
  layered: boolean;
  /** A technique's pass has drawn it this frame; the forward pass leaves it out. */
  drawn: boolean;
}

/** Whether any pass may draw an item in an order of its own. */
export function isPlain({ route }: RenderItem): boolean {
  return route === 'split' || route === 'plain';
}
