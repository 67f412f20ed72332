import { tileCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Tiled forward shading: a list of lights for each tile of 16 × 16 pixels, whatever its depth, over which three's own
 * materials loop. Transparent objects and multisampling work.
 * @see Olsson and Assarsson 2011, Tiled Shading; thesis 2.2.3.3.4
 */
export const tiledForward: Technique = {
  label: 'Tiled forward',
  help: 'A light list for each tile, walked by the materials.',
  lightOrder: 'by-depth',
  needsFloatTargets: false,
  lazy: tileCode,
  passes: () => tileCode.required.tiledForwardPasses(),
};
