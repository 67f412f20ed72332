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
  return [new LightTilesPass('none'), ...forwardTail('lightLoopTiled', ['light-lists'], 'lightLoopTiled', true)];
}

/** The passes of 'forward-plus': a depth pre-pass, light lists by tile, then the materials. */
export function forwardPlusPasses(): Pass[] {
  return [
    new DepthPrepass(),
    new LightTilesPass('slices'),
    // lists are culled by opaque depths: transparent surfaces in front loop over all lights
    ...forwardTail('lightLoopTiled', ['light-lists'], 'lightLoopAll'),
  ];
}

/** The passes of 'tiled-deferred': a G-buffer, light lists by tile, one lighting pass, then forward materials. */
export function tiledDeferredPasses(): Pass[] {
  return [new GBufferPass(), new LightTilesPass('slices'), new TiledOutputPass(), ...forwardTail('lightLoopAll')];
}
