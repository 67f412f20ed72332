import { tileCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Forward+: a depth pre-pass, light lists by tile, limited to the tile's depths and its occupied depth slices (2.5D culling),
 * then three's own materials, which loop over these lists.
 * @see Harada, McKee and Yang 2012, Forward+; Harada 2012, A 2.5D Culling for Forward+; thesis 2.2.3.3.5
 */
export const forwardPlus: Technique = {
  label: 'Forward+',
  help: 'Depth, then a light list for each tile, within its depths, walked by the materials.',
  lightOrder: 'by-depth',
  needsFloatTargets: false,
  lazy: tileCode,
  writes: ['scene-depth'],
  passes: () => tileCode.required.forwardPlusPasses(),
};
