import { gridCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Clustered forward shading: light lists by tile and depth, read by three's own materials; transparent objects and multisampling
 * as in stock three.
 * @see Olsson, Billeter and Assarsson 2012, Clustered Deferred and Forward Shading; Drobot 2017 (z-binning)
 */
export const clusteredForward: Technique = {
  label: 'Clustered forward',
  help: 'Light lists by tile and depth, walked by the materials.',
  lightOrder: 'by-grid',
  needsFloatTargets: false,
  lazy: gridCode,
  passes: () => gridCode.required.clusteredForwardPasses(),
};
