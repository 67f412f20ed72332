import { tileCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Tiled deferred shading: a list of lights for each tile of 16 × 16 pixels, bounded by the depths in the tile, and one
 * lighting pass over the G-buffer.
 * @see Andersson 2009, Parallel Graphics in Frostbite; Olsson and Assarsson 2011, Tiled Shading; thesis 2.2.3.3.4
 */
export const tiledDeferred: Technique = {
  label: 'Tiled deferred',
  help: 'A light list for each tile, within its depths, over a G-buffer.',
  lightOrder: 'by-depth',
  needsFloatTargets: true,
  fills: 'every-pixel',
  lazy: tileCode,
  writes: ['gbuffer'],
  passes: () => tileCode.required.tiledDeferredPasses(),
};
