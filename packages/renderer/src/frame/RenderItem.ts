import type { RenderListItem } from '../three/RenderListItem';

/**
 * Shading of an item: 'lit' by Farol's lights, one at a time; 'shadow-mask' by three's `getShadowMask()`, which Farol's shadows
 * extend; 'nodes' by three itself (node materials, TSL); 'unlit' by its own material.
 */
export type ItemShading = 'lit' | 'unlit' | 'shadow-mask' | 'nodes';

/**
 * Passes that may draw an item, and its order. 'split': opaque, lit by three's unchanged shader: passes may divide its shading,
 * in any order. 'plain': opaque, drawn whole by any pass, in any order. 'ordered': opaque, in three's order, since its picture
 * or a later item's depends on it. 'forward': by the forward pass: transmissive and transparent items, and opaque ones with
 * unusual depth or blending state.
 */
export type ItemRoute = 'split' | 'plain' | 'ordered' | 'forward';

/** One draw from three's traversal, with the host's material (or the scene's override). Pooled: valid only in its frame. */
export interface RenderItem extends RenderListItem {
  shading: ItemShading;
  route: ItemRoute;
  /** Whether the page, or a Farol surface (GLSL that sets material inputs), changes the material's shader. */
  ownShader: boolean;
  /** Whether its layers differ from most objects', so that other lights reach it and it is drawn forward. */
  layered: boolean;
  /** Whether a technique's pass has drawn it in this frame; the forward pass then skips it. */
  drawn: boolean;
}

/** Whether any pass may draw an item, in any order. */
export function isPlain({ route }: RenderItem): boolean {
  return route === 'split' || route === 'plain';
}
