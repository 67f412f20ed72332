import { DepthPrepass } from '../forward/DepthPrepass';
import { LightTilesPass } from '../lighting/lists/LightTilesPass';
import { forwardTail } from './forwardTail';
import type { Technique } from './Technique';

/**
 * Forward+: a depth pre-pass, light lists of tiles within the depths in them and the slices that hold anything (2.5D
 * culling), then three's own materials over these lists.
 * @see Harada, McKee and Yang 2012, Forward+; Harada 2012, A 2.5D Culling for Forward+; thesis 2.2.3.3.5
 */
export const forwardPlus: Technique = {
  label: 'Forward+',
  help: 'Depth, then a light list for each tile, within its depths, walked by the materials.',
  lightOrder: 'by-depth',
  needsFloatTargets: false,
  passes: () => [
    new DepthPrepass(),
    new LightTilesPass('slices'),
    // the lists know only what is opaque: what lies before it is lit by all lights
    ...forwardTail('lightLoopTiled', ['light-lists'], 'lightLoopAll'),
  ],
};
