import { gridCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Clustered deferred shading: light lists by tile and depth, for a G-buffer and for transparent objects.
 * @see Olsson, Billeter and Assarsson 2012, Clustered Deferred and Forward Shading; Drobot 2017 (z-binning)
 */
export const clusteredDeferred: Technique = {
  label: 'Clustered deferred',
  help: 'Light lists by tile and depth, over a G-buffer.',
  lightOrder: 'by-grid',
  needsFloatTargets: true,
  fills: 'every-pixel',
  lazy: gridCode,
  writes: ['gbuffer'],
  passes: () => gridCode.required.clusteredDeferredPasses(),
};
