import { DepthPrepass } from '../../passes/forward/DepthPrepass';
import type { Pass } from '../../frame/Pass';
import { GBufferPass } from '../../passes/gbuffer/GBufferPass';
import { addBuiltinMicroShaders } from '../../microshaders/builtinRegistry';
import * as tiledChunks from './tiledChunks';
import { LightTilesPass } from './LightTilesPass';
import { TiledOutputPass } from './TiledOutputPass';
import { readLightsInRows } from './readLights';
import { forwardTail } from '../forwardTail';

export { rankByDepth } from './rankByDepth';

readLightsInRows();
addBuiltinMicroShaders(tiledChunks);

/** The passes of 'tiled-forward'. */
export function tiledForwardPasses(): Pass[] {
  return [new LightTilesPass('none'), ...forwardTail('lightLoopTiled', ['light-lists'])];
}

/** The passes of 'forward-plus'. */
export function forwardPlusPasses(): Pass[] {
  return [
    new DepthPrepass(),
    new LightTilesPass('slices'),
    // lists are made for opaque surfaces: transparent ones before them loop over all lights
    ...forwardTail('lightLoopTiled', ['light-lists'], 'lightLoopAll'),
  ];
}

/** The passes of 'tiled-deferred'. */
export function tiledDeferredPasses(): Pass[] {
  return [new GBufferPass(), new LightTilesPass('slices'), new TiledOutputPass(), ...forwardTail('lightLoopAll')];
}
